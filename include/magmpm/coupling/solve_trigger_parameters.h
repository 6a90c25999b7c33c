#pragma once

namespace magmpm
{
  /** When the potential is solved again. */
  struct SolveTriggerParameters
  {
    enum class Trigger
    {
      when_changed, ///< material moved by a fraction of dx, or the external field changed
      every_step,
      every_n_steps
    };

    Trigger trigger         = Trigger::when_changed;
    double moved_fraction   = 0.15; ///< of dx
    double changed_fraction = 0.01; ///< of the largest external field
    int n_steps             = 10;
  };
} // namespace magmpm
