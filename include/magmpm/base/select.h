#pragma once

#include <magmpm/base/simd.h>

#include <type_traits>

/**
 * Decisions in point functions that are written once for a number (double) and for several in the
 * lanes of a Simd, whose comparisons give a truth value per lane.
 */
namespace magmpm
{
  /** @p a where the condition holds, otherwise @p b. */
  inline double
  select(const bool condition, const double a, const double b)
  {
    return condition ? a : b;
  }

  template <typename Number, int width>
  inline Simd<Number, width>
  select(const typename Simd<Number, width>::Mask &condition,
         const Simd<Number, width> &a,
         const Simd<Number, width> &b)
  {
    return Simd<Number, width>::select(condition, a, b);
  }

  /** Whether the condition holds in any lane. */
  inline bool
  any(const bool condition)
  {
    return condition;
  }

  template <typename Mask, typename = std::enable_if_t<!std::is_arithmetic_v<Mask>>>
  inline bool
  any(const Mask &condition)
  {
    bool result = false;
    for (std::size_t lane = 0; lane < sizeof(Mask) / sizeof(condition[0]); ++lane)
      result = result || condition[lane] != 0;
    return result;
  }
} // namespace magmpm
