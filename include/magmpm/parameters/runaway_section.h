#pragma once

#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/run_parameters.h>

/** The section Runaway limits. */
namespace magmpm
{
  void
  declare_runaway_limits(ParameterRegister &declarations, RunawayLimits &limits);
} // namespace magmpm
