// Which part of a box a shape fills, found from distances of its surface alone.

#include <magmpm/geometry/column_moments.h>
#include <magmpm/geometry/shape.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** The plane that is nearest to the distances of a surface at the Gauss points of a box. */
    template <int dim>
    struct FittedPlane
    {
      double distance = 0.;  ///< of the middle of the box [m]
      Vector<dim> gradient;  ///< of length 1 where the surface is flat [-]
      double departure = 0.; ///< of a distance from the plane's, at most [m]
    };

    template <int dim>
    FittedPlane<dim>
    fit_plane(const Shape<dim> &shape, const BoundingBox<dim> &box)
    {
      constexpr int n_points   = 1 << dim;
      const Vector<dim> middle = middle_of(box);
      const Vector<dim> reach  = (0.5 / std::sqrt(3.)) * (box.upper - box.lower);
      const auto side          = [](const int point, const int d) {
        return ((point >> d) & 1) != 0 ? 1. : -1.;
      };
      double distances[n_points];
      FittedPlane<dim> plane;
      for (int i = 0; i < n_points; ++i)
        {
          Vector<dim> point = middle;
          for (int d = 0; d < dim; ++d)
            point[d] += side(i, d) * reach[d];
          distances[i] = shape.surface_distance(point).distance;
          plane.distance += distances[i] / n_points;
          for (int d = 0; d < dim; ++d)
            plane.gradient[d] += side(i, d) * distances[i] / (n_points * reach[d]);
        }
      for (int i = 0; i < n_points; ++i)
        {
          double of_plane = plane.distance;
          for (int d = 0; d < dim; ++d)
            of_plane += side(i, d) * reach[d] * plane.gradient[d];
          plane.departure = std::max(plane.departure, std::abs(distances[i] - of_plane));
        }
      return plane;
    }

    /** Where a surface is as good as flat: departures over the edge of the box, and lengths of gradients. */
    constexpr double flat = 0.005, steep = 0.9995;
  } // namespace

  template <int dim>
  RegionMoments<dim>
  Shape<dim>::moments_within(const BoundingBox<dim> &box, const int depth) const
  {
    const Vector<dim> edges = box.upper - box.lower;
    const double distance   = surface_distance(middle_of(box)).distance;
    if (std::abs(distance) >= 0.5 * norm(edges))
      return distance < 0. ? moments_of(box) : RegionMoments<dim>();

    const FittedPlane<dim> plane = fit_plane(*this, box);
    const double length          = norm(plane.gradient);
    if (depth == 0 && length < 1e-6)
      return plane.distance < 0. ? moments_of(box) : RegionMoments<dim>();
    const double edge = *std::max_element(edges.values, edges.values + dim);
    if (depth == 0 || (plane.departure <= flat * edge && length >= steep))
      return moments_below_plane(box, plane.distance, plane.gradient);

    RegionMoments<dim> sum;
    for (int i = 0; i < (1 << dim); ++i)
      {
        const BoundingBox<dim> octant = octant_of(box, i);
        sum += moved_to(moments_within(octant, depth - 1), middle_of(box) - middle_of(octant));
      }
    return sum;
  }

  template RegionMoments<2>
  Shape<2>::moments_within(const BoundingBox<2> &, int) const;
  template RegionMoments<3>
  Shape<3>::moments_within(const BoundingBox<3> &, int) const;
} // namespace magmpm
