#pragma once

#include <cmath>

namespace magmpm::verification
{
  /** Where a function is least between two places, if it has one minimum there: the golden section, to 1e-8 of them. */
  template <typename Function>
  double
  place_of_minimum(const Function &function, double lower, double upper)
  {
    const double part = 0.5 * (std::sqrt(5.) - 1.);
    double a = upper - part * (upper - lower), b = lower + part * (upper - lower);
    double at_a = function(a), at_b = function(b);
    for (int i = 0; i < 40; ++i)
      if (at_a < at_b)
        {
          upper = b;
          b     = a;
          at_b  = at_a;
          a     = upper - part * (upper - lower);
          at_a  = function(a);
        }
      else
        {
          lower = a;
          a     = b;
          at_a  = at_b;
          b     = lower + part * (upper - lower);
          at_b  = function(b);
        }
    return 0.5 * (lower + upper);
  }
} // namespace magmpm::verification
