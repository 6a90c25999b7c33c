#pragma once

#include <magmpm/simulation/checkpoint.h>
#include <magmpm/results/results.h>
#include <magmpm/simulation/run_state.h>
#include <magmpm/particles/body.h>
#include <magmpm/simulation/time_step_control.h>

#include <optional>
#include <string>
#include <vector>

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

  /**
   * The checkpoint of a run.
   *
   * @param parameters  Parameters::complete_text
   * @param bodies      with this rank's particles.
   */
  template <int dim>
  Checkpoint
  make_checkpoint(const RunRecord &record,
                  const std::string &parameters,
                  const std::vector<Body<dim>> &bodies);

  /** The record in a checkpoint; nothing without one. */
  std::optional<RunRecord>
  run_record_of(const std::optional<Checkpoint> &checkpoint);
} // namespace magmpm
