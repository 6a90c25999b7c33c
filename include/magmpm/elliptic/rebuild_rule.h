#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace magmpm
{
  /**
   * When the preconditioner has served its time: as soon as CG needs twice the iterations per digit
   * that it needed at best since the last rebuild (two more are allowed, as iterations are whole
   * numbers).
   */
  class RebuildRule
  {
  public:
    bool
    is_due() const
    {
      return due;
    }

    void
    rebuilt()
    {
      due                  = false;
      iterations_per_digit = std::numeric_limits<double>::infinity();
    }

    void
    count(const int iterations, const double relative_tolerance)
    {
      const double digits  = std::max(0.5, -std::log10(relative_tolerance));
      iterations_per_digit = std::min(iterations_per_digit, iterations / digits);
      due                  = iterations > 2. * iterations_per_digit * digits + 2.;
    }

  private:
    bool due                    = true;
    double iterations_per_digit = 0.;
  };
} // namespace magmpm
