#pragma once

#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/run_parameters.h>

/** When checkpoints are written and when a run stops by itself: parameters outside of all sections. */
namespace magmpm
{
  void
  declare_checkpoint(ParameterRegister &declarations, CheckpointParameters &checkpoint);

  /** Reads what is given as a time with its unit, a number of frames, or never. */
  void
  convert_checkpoint(const ParameterRegister &declarations, CheckpointParameters &checkpoint);
} // namespace magmpm
