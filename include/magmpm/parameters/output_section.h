#pragma once

#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/run_parameters.h>

/** The section Output. */
namespace magmpm
{
  void
  declare_output(ParameterRegister &declarations, OutputParameters &output);
} // namespace magmpm
