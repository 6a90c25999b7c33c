#pragma once

#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/run_parameters.h>

/** The section Time step. */
namespace magmpm
{
  void
  declare_time_step(ParameterRegister &declarations, TimeStepParameters &time_step);

  /** @param frame_interval  which a given step must not exceed [s]. */
  void
  check_time_step(const ParameterRegister &declarations,
                  const TimeStepParameters &step,
                  const double frame_interval);
} // namespace magmpm
