#pragma once

#include <magmpm/geometry/shape.h>

#include <string>

namespace magmpm
{
  /** One named body of a scene: where its particles are seeded and how they move at first. */
  template <int dim>
  struct BodyParameters
  {
    std::string name;
    std::string material;
    ShapeParameters<dim> shape;
    double density         = 0.; ///< undeformed [kg/m^3]
    int particles_per_edge = 2;  ///< of a lattice cell: 2 means 2^dim per cell
    double jitter          = 0.; ///< fraction of the particle spacing, 0 (regular) to 1

    Vector<dim> velocity; ///< at the start [m/s]
    Vector<n_axial_components<dim>>
      angular_velocity; ///< spin at the start, about the centre of mass [rad/s]
  };
} // namespace magmpm
