#pragma once

#include <complex>

namespace magmpm::verification
{
  /** A zero of an analytic function near @p start, by secants. */
  template <typename Function>
  std::complex<double>
  complex_zero(const Function &function, const std::complex<double> start)
  {
    std::complex<double> before = start * (1. + 1e-4), now = start, f_before = function(before);
    for (int i = 0; i < 100; ++i)
      {
        const std::complex<double> f = function(now);
        if (f == f_before)
          break;
        const std::complex<double> change = -f * (now - before) / (f - f_before);
        before                            = now;
        f_before                          = f;
        now += change;
        if (std::abs(change) < 1e-13 * std::abs(now))
          break;
      }
    return now;
  }
} // namespace magmpm::verification
