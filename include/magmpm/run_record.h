#pragma once

#include <magmpm/io/results.h>
#include <magmpm/io/run_state.h>
#include <magmpm/time_step_control.h>

namespace magmpm
{
  /** What a checkpoint holds of a run besides its particles, the same on all ranks. */
  struct RunRecord
  {
    RunState state;
    StepConditions step_conditions;
    ResultsProgress progress;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &state;
      archive &step_conditions;
      archive &progress;
    }
  };
} // namespace magmpm
