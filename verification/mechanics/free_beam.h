#pragma once

#include <magmpm/materials/material_parameters.h>

namespace magmpm::verification
{
  /** A beam of 40 x 1 mm in free space, in 2D (plane strain). */
  struct FreeBeam
  {
    int cells             = 2;  ///< of the lattice over its thickness
    double offset         = 0.; ///< from the lattice, along its thickness [dx]
    double poisson_ratio  = 0.;
    Transfer transfer     = Transfer::fmpm;
    double elastic_factor = 0.4;
  };

  /**
   * What couples on the halves of a free beam, turned against each other, make of it: a V, each half the
   * elastica of BeamLoad::couple. Relative errors with their signs.
   */
  struct VBeamErrors
  {
    double height, reach; ///< of its ends from its middle
    double angle_of_ends; ///< of the shape, against that which F adds up to
  };

  /**
   * @param load      q of BeamLoad::couple.
   * @param damping   of the velocity, in 2 pi/T_1, T_1 the first period of a cantilever as long as a half.
   * @param periods   time of the run, in T_1.
   * @param way       over which the beam is carried meanwhile, in its half length.
   */
  VBeamErrors
  v_beam_errors(const FreeBeam &beam,
                const double load,
                const double damping,
                const double periods,
                const double way = 0.);

  /** Of what the start has. */
  struct EnergyLeft
  {
    double at_end, largest;
  };

  /** A free beam swings in its first bending mode, amplitude 0.3 of its half length, four periods. */
  EnergyLeft
  energy_of_swinging_beam(const FreeBeam &beam);

  /** What a free bar of 16 x 4 cells, nu = 0, loses a period of its energy, in the first mode along it. */
  double
  loss_of_bar(const Transfer transfer, const double elastic_factor);

  /** Of a block of 8 cells an edge that spins ten turns, its edge moving with 0.05 c: relative. */
  template <int dim>
  double
  change_of_angular_momentum(const Transfer transfer);
} // namespace magmpm::verification
