#pragma once

#include <verification/capillarity/drop_modes.h>

#include <array>
#include <string>

/** Drops of magmpm without gravity in a box that is open, in units of U = sqrt(gamma/(rho R)) and T = R/U. */
namespace magmpm::verification
{
  struct DropRun
  {
    int dim                      = 2;
    int cells                    = 8;                 ///< R/dx
    double laplace_number        = 12000.;            ///< rho gamma 2 R/mu^2
    double sound                 = 10.;               ///< sqrt(K/rho), over sqrt(gamma/(rho dx))
    std::array<double, 3> offset = {0.2, 0.37, 0.13}; ///< of the centre from a node [dx]
    double amplitude             = 0.; ///< eps of r = R (1 + eps Y_2 - ..) at the start
    double velocity              = 0.; ///< along x [U]
    double duration              = 8.; ///< [T]
    int particles_per_edge       = 0;  ///< of a cell; 0: 4 in 2D, 2 in 3D
    unsigned int seed            = 1;

    /** With the viscosity of the Laplace number, of the size and material of a drop of ferrofluid. */
    Drop
    drop() const;
  };

  /** A drop at rest, means over the later half of the run. */
  struct RestingDrop
  {
    double pressure;         ///< mean K (1 - J) within R/2, over (dim - 1) gamma/R, less 1
    double rms;              ///< velocity of the particles [U]
    double largest;          ///< of them [U]
    double momentum;         ///< largest change [M U]
    double angular_momentum; ///< largest [M U R]
    double surface; ///< energy of the surface over gamma times that of the sphere (circle), less 1
  };

  /** With a velocity: the same in the frame of the drop, of one that flies over 4 dx and more. */
  RestingDrop
  resting_drop(const DropRun &run);

  /** What of the flight of a drop differs from that of a rigid body. */
  struct MovedDrop
  {
    RestingDrop drop;
    double speed; ///< of its centre at the end, over that at the start, less 1
    double
      aspect; ///< sqrt of the ratio of second moments along and across the flight, less 1, at the end
  };

  MovedDrop
  moved_drop(const DropRun &run);

  /** The mode n = 2, by the second moments of the particles; against the whole equation for viscous drops. */
  struct OscillatingDrop
  {
    double frequency; ///< over the exact one, less 1
    double damping;   ///< likewise
    double misfit;    ///< of the fit, over the amplitude
    double momentum;  ///< largest change [M U]
  };

  OscillatingDrop
  oscillating_drop(const DropRun &run);
} // namespace magmpm::verification
