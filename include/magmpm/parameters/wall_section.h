#pragma once

#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/parameters/parameter_register.h>

/** The section Walls. */
namespace magmpm
{
  template <int dim>
  void
  declare_walls(ParameterRegister &declarations, WallParameters<dim> &walls);
} // namespace magmpm
