#pragma once

#include <speed_against_error/contender.h>

#include <limits>
#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** Repeated runs of one contender in one experiment at one R/dx, each at another place. */
  class Measurement
  {
  public:
    Measurement(const Scheme scheme, const std::string &contender, const int resolution)
      : scheme(scheme)
      , contender(contender)
      , resolution(resolution)
    {
    }

    void
    add(const Outcome &outcome, const StateErrors &errors);

    /** Root mean square over the runs, so that no change of sign hides an error. */
    StateErrors
    rms_errors() const;

    const Scheme scheme;
    const std::string contender;
    const int resolution;

    // Each the fastest of all runs.
    SolveCost cold;
    SolveCost warm;

    int n_runs                    = 0;
    unsigned long long n_unknowns = 0;

    /** The fastest warm run over its CG iterations: what is no CG is counted with it. */
    double
    nanoseconds_per_unknown_and_iteration() const;

  private:
    StateErrors squares = {0., 0., 0., 0.}; ///< sums over the runs
  };

  /** When a contender has come down to an error. */
  struct TimeToError
  {
    enum class Kind
    {
      interpolated,
      at_most,     ///< it is there with the coarsest lattice
      extrapolated ///< not even with the finest
    };

    Kind kind         = Kind::interpolated;
    double seconds    = std::numeric_limits<double>::quiet_NaN();
    double error_step = 1.; ///< extrapolated: finest error over the one asked for

    /** "0.34", "< 0.0012", "31 (extrapolated 1.4x)". */
    std::string
    text() const;
  };

  /**
   * The time to come down to an @p error and stay there: the line through time and error, both as
   * logarithms, between the last lattice that is above the error and the next. Beyond the finest
   * lattice the straight line that fits all of them best goes on, if the error still falls.
   *
   * @param series  of one contender, by growing resolution.
   * @param member  which error.
   * @param cost    &Measurement::cold or &Measurement::warm.
   */
  TimeToError
  time_to_error(const std::vector<const Measurement *> &series,
                double StateErrors::*member,
                SolveCost Measurement::*cost,
                const double error);
} // namespace magmpm::benchmarks
