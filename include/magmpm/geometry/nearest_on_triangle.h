#pragma once

#include <magmpm/base/tensor.h>

namespace magmpm
{
  /**
   * The point of the triangle a, b, c that is nearest to @p point: by the Voronoi regions of corners
   * and sides (Ericson, Real-Time Collision Detection, 5.1.5).
   */
  inline Vector<3>
  nearest_on_triangle(const Vector<3> &point,
                      const Vector<3> &a,
                      const Vector<3> &b,
                      const Vector<3> &c)
  {
    const Vector<3> ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
    const double ab_a = dot(ab, ap), ac_a = dot(ac, ap);
    if (ab_a <= 0. && ac_a <= 0.)
      return a;
    const double ab_b = dot(ab, bp), ac_b = dot(ac, bp);
    if (ab_b >= 0. && ac_b <= ab_b)
      return b;
    const double of_c = ab_a * ac_b - ab_b * ac_a;
    if (of_c <= 0. && ab_a >= 0. && ab_b <= 0.)
      return a + (ab_a / (ab_a - ab_b)) * ab;
    const double ab_c = dot(ab, cp), ac_c = dot(ac, cp);
    if (ac_c >= 0. && ab_c <= ac_c)
      return c;
    const double of_b = ab_c * ac_a - ab_a * ac_c;
    if (of_b <= 0. && ac_a >= 0. && ac_c <= 0.)
      return a + (ac_a / (ac_a - ac_c)) * ac;
    const double of_a     = ab_b * ac_c - ab_c * ac_b;
    const double beyond_b = ac_b - ab_b, beyond_c = ab_c - ac_c;
    if (of_a <= 0. && beyond_b >= 0. && beyond_c >= 0.)
      return b + (beyond_b / (beyond_b + beyond_c)) * (c - b);
    const double sum = of_a + of_b + of_c;
    return a + (of_b / sum) * ab + (of_c / sum) * ac;
  }
} // namespace magmpm
