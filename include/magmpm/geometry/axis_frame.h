#pragma once

#include <magmpm/base/tensor.h>

#include <cmath>

/** Directions of shapes that are round about an axis. */
namespace magmpm
{
  inline Vector<3>
  unit(const Vector<3> &a)
  {
    return (1. / norm(a)) * a;
  }

  /** At a right angle to @p direction, which has length 1. */
  inline Vector<3>
  any_across(const Vector<3> &direction)
  {
    Vector<3> other;
    other[std::abs(direction[0]) < 0.6 ? 0 : 1] = 1.;
    return unit(cross(direction, other));
  }
} // namespace magmpm
