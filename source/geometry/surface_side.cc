#include <magmpm/geometry/surface_side.h>

namespace magmpm
{
  template <int dim>
  SurfaceSide
  side_of(const Shape<dim> &shape, const Vector<dim> &point, const double tolerance)
  {
    // Of the ways along the axes one leads across a surface near by, whatever its normal.
    const bool is_inside = shape.contains(point);
    for (int d = 0; d < dim; ++d)
      for (const double step : {-tolerance, tolerance})
        {
          Vector<dim> other = point;
          other[d] += step;
          if (shape.contains(other) != is_inside)
            return SurfaceSide::surface;
        }
    return is_inside ? SurfaceSide::inside : SurfaceSide::outside;
  }

  template SurfaceSide
  side_of(const Shape<2> &, const Vector<2> &, double);
  template SurfaceSide
  side_of(const Shape<3> &, const Vector<3> &, double);
} // namespace magmpm
