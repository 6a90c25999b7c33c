#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/lattice/lattice.h>

#include <cmath>
#include <string>

namespace magmpm
{
  /** Which of the places in a lattice cell, n along each edge, hold particles at the start. */
  enum class Arrangement
  {
    cubic,       ///< all: n^dim particles a cell
    face_centred ///< every other, like the fields of one colour of a chessboard: n^dim/2
  };

  /** Of what volume particles are at the start. */
  enum class InitialState
  {
    undeformed,
    hydrostatic ///< of a fluid: compressed by the weight of what stands above (HydrostaticColumns)
  };

  /** One named body of a scene: where its particles are seeded and how they move at first. */
  template <int dim>
  struct BodyParameters
  {
    std::string name;
    std::string material;
    ShapeParameters<dim> shape;
    double density          = 0.; ///< undeformed [kg/m^3]
    int particles_per_edge  = 2;  ///< of a lattice cell: 2 means 2^dim per cell
    Arrangement arrangement = Arrangement::cubic;
    double jitter           = 0.; ///< fraction of the particle spacing, 0 (regular) to 1

    InitialState initial_state = InitialState::undeformed;

    /** Bodies of one group are one piece where they meet, those of different ones touch and part. */
    int contact_group = 0;

    Vector<dim> velocity; ///< at the start [m/s]
    Vector<n_axial_components<dim>>
      angular_velocity; ///< spin at the start, about the centre of mass [rad/s]

    /** Of an undeformed particle in a full cell, the mean of them [m^3], in 2D [m^2]. */
    double
    particle_volume(const Lattice<dim> &lattice) const
    {
      const double place = std::pow(lattice.spacing / particles_per_edge, dim);
      return arrangement == Arrangement::face_centred ? 2. * place : place;
    }
  };
} // namespace magmpm
