#pragma once

#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/parameters/parameter_register.h>

/** The section Walls. */
namespace magmpm
{
  template <int dim>
  void
  declare_walls(ParameterRegister &declarations, WallParameters<dim> &walls);

  /** @throw InputError  if a contact angle is given where no line moves. */
  template <int dim>
  void
  check_walls(const ParameterRegister &declarations, const WallParameters<dim> &walls);
} // namespace magmpm
