#pragma once

#include <magmpm/parameters/run_parameters.h>
#include <magmpm/simulation/run_state.h>

#include <string>

namespace magmpm
{
  /**
   * Whether all material has come to rest: since when the root mean square of its speed, by mass, has
   * been below the limit whenever one looked. What it must remember is in the RunState.
   */
  class RestCheck
  {
  public:
    explicit RestCheck(const RestParameters &parameters)
      : parameters(parameters)
    {
    }

    /** Whether it is time for note_speed(): every ten steps, if rest ends the run. */
    bool
    is_due(const RunState &state) const
    {
      return parameters.stops && state.step % period == 0;
    }

    /** @param mean_square_speed  2 E_kin/m [m^2/s^2] of all material. */
    void
    note_speed(const double mean_square_speed, RunState &state) const;

    /** Whether rest has lasted long enough to end the run. */
    bool
    is_over(const RunState &state) const;

    /** Why the run ended, for the log. */
    std::string
    reason() const;

  private:
    static constexpr unsigned int period = 10; ///< steps

    const RestParameters parameters;
  };
} // namespace magmpm
