#pragma once

#include <magmpm/parameters/run_parameters.h>

#include <string>

namespace magmpm
{
  /**
   * Whether all material has come to rest: since when the root mean square of its speed, by mass, has
   * been below the limit whenever one looked.
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
    is_due(const unsigned int step) const
    {
      return parameters.stops && step % period == 0;
    }

    /** @param mean_square_speed  2 E_kin/m [m^2/s^2] of all material. @param time  of now [s]. */
    void
    note_speed(const double mean_square_speed, const double time);

    /** Whether rest has lasted long enough to end the run. */
    bool
    is_over(const double time) const;

    /** Why the run ended, for the log. */
    std::string
    reason() const;

    /** What it must remember: since when the material is at rest [s]; negative: it is not. */
    double since = -1.;

  private:
    static constexpr unsigned int period = 10; ///< steps

    const RestParameters parameters;
  };
} // namespace magmpm
