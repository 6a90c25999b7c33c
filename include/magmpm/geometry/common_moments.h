#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /** What two shapes fill of a box, each alone and together: moments about its middle. */
  template <int dim>
  struct PartsOfBox
  {
    PartsOfBox(const Shape<dim> &first,
               const Shape<dim> &second,
               const BoundingBox<dim> &box,
               const int depth);

    RegionMoments<dim> of_first, of_second;

    /** What both fill (CombinedShape::moments_within() says how exactly). */
    RegionMoments<dim>
    common() const;

  private:
    const Shape<dim> &first, &second;
    const BoundingBox<dim> box;
    const int depth;

    /** The same without looking at parts of the box. */
    RegionMoments<dim>
    estimate() const;

    /** Whether both surfaces cross the box. */
    bool
    both_cross() const;
  };
} // namespace magmpm
