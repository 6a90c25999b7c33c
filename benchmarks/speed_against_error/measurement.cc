#include <speed_against_error/measurement.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace magmpm::benchmarks
{
  namespace
  {
    void
    keep_fastest(const SolveCost &cost, const bool is_first, SolveCost &fastest)
    {
      if (is_first || cost.seconds < fastest.seconds)
        fastest = cost;
    }

    /** ln(time) on the line through two points, at ln(error). */
    double
    on_line(const double x, const double x0, const double y0, const double x1, const double y1)
    {
      return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
    }

    /** y at x of the line of least squares. */
    double
    on_fitted_line(const double x, const std::vector<double> &xs, const std::vector<double> &ys)
    {
      const double n = static_cast<double>(xs.size());
      double mean_x = 0., mean_y = 0., xx = 0., xy = 0.;
      for (std::size_t i = 0; i < xs.size(); ++i)
        {
          mean_x += xs[i] / n;
          mean_y += ys[i] / n;
        }
      for (std::size_t i = 0; i < xs.size(); ++i)
        {
          xx += (xs[i] - mean_x) * (xs[i] - mean_x);
          xy += (xs[i] - mean_x) * (ys[i] - mean_y);
        }
      return mean_y + xy / xx * (x - mean_x);
    }
  } // namespace

  void
  Measurement::add(const Outcome &outcome, const StateErrors &errors)
  {
    keep_fastest(outcome.cold, n_runs == 0, cold);
    keep_fastest(outcome.warm, n_runs == 0, warm);
    n_unknowns = outcome.n_unknowns;
    for (const auto member : error_members)
      squares.*member += errors.*member * errors.*member;
    ++n_runs;
  }

  StateErrors
  Measurement::rms_errors() const
  {
    StateErrors result = squares;
    for (const auto member : error_members)
      result.*member = std::sqrt(squares.*member / n_runs);
    return result;
  }

  double
  Measurement::nanoseconds_per_unknown_and_iteration() const
  {
    return 1e9 * warm.seconds / (static_cast<double>(n_unknowns) * std::max(1, warm.cg_iterations));
  }

  std::string
  TimeToError::text() const
  {
    char number[64];
    switch (kind)
      {
        case Kind::interpolated:
          std::snprintf(number, sizeof(number), "%.2g", seconds);
          break;
        case Kind::at_most:
          std::snprintf(number, sizeof(number), "< %.2g", seconds);
          break;
        case Kind::extrapolated:
          if (std::isfinite(seconds))
            std::snprintf(number, sizeof(number), "%.2g (extrapolated %.1fx)", seconds, error_step);
          else
            std::snprintf(number, sizeof(number), "not reached");
          break;
      }
    return number;
  }

  TimeToError
  time_to_error(const std::vector<const Measurement *> &series,
                double StateErrors::*member,
                SolveCost Measurement::*cost,
                const double error)
  {
    std::vector<double> log_error, log_time;
    for (const Measurement *const measurement : series)
      {
        log_error.push_back(std::log(measurement->rms_errors().*member));
        log_time.push_back(std::log((measurement->*cost).seconds));
      }
    TimeToError result;
    const double target = std::log(error);

    // All from this one on are below the error.
    std::size_t first = log_error.size();
    while (first > 0 && log_error[first - 1] <= target)
      --first;

    if (first == 0 && !log_error.empty())
      {
        result.kind    = TimeToError::Kind::at_most;
        result.seconds = std::exp(log_time[0]);
      }
    else if (first < log_error.size())
      result.seconds = std::exp(on_line(
        target, log_error[first - 1], log_time[first - 1], log_error[first], log_time[first]));
    else
      {
        // Nothing is to be said of an error that no longer falls, nor of one that is too far.
        constexpr double farthest = 3.;
        const double falling      = std::log(0.95);
        result.kind               = TimeToError::Kind::extrapolated;
        if (log_error.size() >= 3 && log_error.back() < log_error[log_error.size() - 2] + falling)
          {
            result.error_step = std::exp(log_error.back() - target);
            // Parallel to the fitted line through the finest.
            const double beyond = on_fitted_line(target, log_error, log_time) -
                                  on_fitted_line(log_error.back(), log_error, log_time);
            if (beyond > 0. && result.error_step <= farthest)
              result.seconds = std::exp(log_time.back() + beyond);
          }
      }
    return result;
  }
} // namespace magmpm::benchmarks
