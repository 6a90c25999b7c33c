#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /**
   * Whether two shapes in the same frame share more than their surfaces: whether points on the surface
   * of one, at most @p spacing [m] apart, lie inside the other. An overlap that is deeper than
   * spacing^2/(4 R), R the larger of the radii of curvature, is found.
   */
  template <int dim>
  bool
  overlap(const Shape<dim> &a, const Shape<dim> &b, const double spacing);
} // namespace magmpm
