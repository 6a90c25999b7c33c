#pragma once

#include <magmpm/base/tensor.h>

namespace magmpm
{
  /** The magnetic medium in one octant of a mesh cell. */
  template <int dim>
  struct MaterialSample
  {
    Vector<dim> position;      ///< where H of the sources is taken [m]
    double weight;             ///< of the quadrature [m^dim]
    double fraction;           ///< of the volume that is magnetic material [-]
    Vector<dim> field;         ///< H, the total one, in the material [A/m]
    Vector<dim> magnetization; ///< mean M over material and vacuum [A/m]: int M is the moment
    double number_density;     ///< of grains, mean over material and vacuum [1/m^3]
  };
} // namespace magmpm
