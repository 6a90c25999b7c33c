#pragma once

#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/run_parameters.h>

/** The section Rest. */
namespace magmpm
{
  void
  declare_rest(ParameterRegister &declarations, RestParameters &rest);

  void
  check_rest(const ParameterRegister &declarations, const RestParameters &rest);
} // namespace magmpm
