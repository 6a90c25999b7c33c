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
    double moved_fraction   = 0.15;  ///< of dx
    double changed_fraction = 0.01;  ///< of the largest external field
    double force_tolerance  = 0.003; ///< of force, torque and virial, of the carried force
    int n_steps             = 10;
  };
} // namespace magmpm
