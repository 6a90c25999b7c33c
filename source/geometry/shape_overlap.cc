#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/geometry/surface_side.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Lengths that differ by less than this part of themselves are the same. */
    constexpr double same_length = 1e-9;

    template <int dim>
    bool
    boxes_overlap(const BoundingBox<dim> &a, const BoundingBox<dim> &b)
    {
      for (int d = 0; d < dim; ++d)
        {
          const double shared = std::min(a.upper[d], b.upper[d]) - std::max(a.lower[d], b.lower[d]);
          if (shared <= same_length * (a.upper[d] - a.lower[d]))
            return false;
        }
      return true;
    }

    /** Whether a point of the surface of @p a, or its centroid, lies inside @p b. */
    template <int dim>
    bool
    reaches_into(const Shape<dim> &a, const Shape<dim> &b, const double spacing)
    {
      // A point on both surfaces does not count, so that shapes which only touch do not overlap.
      const BoundingBox<dim> box = b.bounding_box();
      const double margin        = same_length * norm(box.upper - box.lower);
      const auto lies_in_b       = [&](const Vector<dim> &point) {
        return b.contains(point) && side_of(b, point, margin) == SurfaceSide::inside;
      };
      const Vector<dim> centroid            = a.volume_moments().centroid;
      const std::vector<Vector<dim>> points = a.surface_points(spacing);
      return (a.contains(centroid) && b.contains(centroid)) ||
             std::any_of(points.begin(), points.end(), lies_in_b);
    }
  } // namespace

  template <int dim>
  bool
  overlap(const Shape<dim> &a, const Shape<dim> &b, const double spacing)
  {
    return boxes_overlap(a.bounding_box(), b.bounding_box()) &&
           (reaches_into(a, b, spacing) || reaches_into(b, a, spacing));
  }

  template bool
  overlap(const Shape<2> &, const Shape<2> &, double);
  template bool
  overlap(const Shape<3> &, const Shape<3> &, double);
} // namespace magmpm
