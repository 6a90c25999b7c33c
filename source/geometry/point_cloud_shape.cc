#include <magmpm/geometry/point_cloud_shape.h>

#include <algorithm>
#include <limits>

namespace magmpm
{
  template <int dim>
  PointCloudShape<dim>::PointCloudShape(const PointCloud<dim> &cloud)
    : all_points(cloud)
  {
  }

  template <int dim>
  bool
  PointCloudShape<dim>::contains(const Vector<dim> &) const
  {
    return false;
  }

  template <int dim>
  SurfaceDistance<dim>
  PointCloudShape<dim>::surface_distance(const Vector<dim> &point) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    Vector<dim> from_nearest;
    for (const Vector<dim> &candidate : all_points.points)
      if (norm_square(point - candidate) < smallest)
        {
          from_nearest = point - candidate;
          smallest     = norm_square(from_nearest);
        }
    const double distance = norm(from_nearest);
    if (distance > 0.)
      return {distance, (1. / distance) * from_nearest};
    from_nearest[0] = 1.;
    return {0., from_nearest};
  }

  template <int dim>
  BoundingBox<dim>
  PointCloudShape<dim>::bounding_box() const
  {
    BoundingBox<dim> box = {all_points.points.front(), all_points.points.front()};
    for (const Vector<dim> &point : all_points.points)
      for (int d = 0; d < dim; ++d)
        {
          box.lower[d] = std::min(box.lower[d], point[d]);
          box.upper[d] = std::max(box.upper[d], point[d]);
        }
    return box;
  }

  template <int dim>
  VolumeMoments<dim>
  PointCloudShape<dim>::volume_moments() const
  {
    const auto volume_of = [&](const std::size_t i) {
      return all_points.volumes.empty() ? 1. : all_points.volumes[i];
    };
    VolumeMoments<dim> moments = {};
    for (std::size_t i = 0; i < all_points.points.size(); ++i)
      {
        moments.volume += volume_of(i);
        moments.centroid += volume_of(i) * all_points.points[i];
      }
    moments.centroid *= 1. / moments.volume;
    for (std::size_t i = 0; i < all_points.points.size(); ++i)
      {
        const Vector<dim> r = all_points.points[i] - moments.centroid;
        moments.second += volume_of(i) * outer(r, r);
      }
    return moments;
  }

  template <int dim>
  RegionMoments<dim>
  PointCloudShape<dim>::moments_within(const BoundingBox<dim> &, const int) const
  {
    return {};
  }

  template <int dim>
  std::vector<Vector<dim>>
  PointCloudShape<dim>::surface_points(const double) const
  {
    return all_points.points;
  }

  template class PointCloudShape<2>;
  template class PointCloudShape<3>;
} // namespace magmpm
