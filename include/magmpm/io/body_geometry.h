#pragma once

#include <magmpm/particles/body_parameters.h>

namespace magmpm
{
  /** A box with edges along the axes [m]. */
  template <int dim>
  struct Extent
  {
    Vector<dim> lower, upper;
  };

  /** The smallest box around the shape of a body. */
  template <int dim>
  Extent<dim>
  extent(const BodyParameters<dim> &body);

  /** Distance of @p point from the shape of a body [m]; zero inside. */
  template <int dim>
  double
  distance(const BodyParameters<dim> &body, const Vector<dim> &point);

  /**
   * Whether two bodies share more than their surfaces. Of cylinders only the overlap with a sphere
   * is found; other pairs with a cylinder count as apart.
   */
  template <int dim>
  bool
  overlap(const BodyParameters<dim> &a, const BodyParameters<dim> &b);
} // namespace magmpm
