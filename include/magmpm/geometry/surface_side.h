#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  enum class SurfaceSide
  {
    inside,
    surface,
    outside
  };

  /** Where a point lies; within about @p tolerance [m] of the surface it counts as on it. */
  template <int dim>
  SurfaceSide
  side_of(const Shape<dim> &shape, const Vector<dim> &point, const double tolerance);
} // namespace magmpm
