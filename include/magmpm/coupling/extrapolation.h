#pragma once

#include <magmpm/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  /**
   * How a force, known at two solves, goes on after the second: its rate of change per way [.../m],
   * (now - before)/way. s is a way, that of the material and the sources: a force depends on places, so
   * this holds too where the speed changes. To second order the force follows the motion, where a
   * constant one would lag behind.
   *
   * Over a way as long as the last one it changes by at most half of itself, so that an impact, or a
   * magnet switched on, is not carried on.
   *
   * @param way  between the two [m]; not positive: the rate is zero.
   */
  template <int n>
  Vector<n>
  extrapolation_rate(const Vector<n> &before, const Vector<n> &now, const double way)
  {
    constexpr double largest_change = 0.5; // of now, over a way as long as the last

    if (!(way > 0.))
      return {};
    const Vector<n> change = now - before;
    const double allowed   = largest_change * norm(now);
    double factor          = 1. / way;
    if (norm(change) > allowed)
      factor *= allowed / norm(change);
    return factor * change;
  }

  /**
   * How much of the tolerated way the next interval between solves may take, so that the force carried over it stays
   * within a tolerance: by the error of the last one, which grows with the square of the way where the rate is
   * known. No less than 0.4 and no more than 2 times the share before, and between 0.2 and 1.
   *
   * @param share  that the last interval was to take. @param taken  what it took, in steps.
   * @param error  of the carried force at its end.
   */
  inline double
  next_share(const double share, const double taken, const double error, const double tolerance)
  {
    const double wanted = error > 0. ? taken * std::sqrt(tolerance / error) : 1.;
    return std::clamp(std::clamp(wanted, 0.4 * share, 2. * share), 0.2, 1.);
  }
} // namespace magmpm
