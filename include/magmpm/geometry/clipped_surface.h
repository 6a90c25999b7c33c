#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /**
   * The part of a surface that lies inside or outside of a shape: facets that the shape's surface may
   * cross are cut in two until no edge is longer than @p spacing [m], then where the distance,
   * interpolated along their edges, is 0. For pictures.
   */
  template <int dim>
  SurfaceMesh<dim>
  clipped_surface(const SurfaceMesh<dim> &surface,
                  const Shape<dim> &shape,
                  const bool keeps_inside,
                  const double spacing);
} // namespace magmpm
