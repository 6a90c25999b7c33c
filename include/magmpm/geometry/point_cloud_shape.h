#pragma once

#include <magmpm/geometry/point_cloud.h>

namespace magmpm
{
  /**
   * A list of points as a shape: of itself it contains nothing, its surface are the points, and its
   * volume is theirs (1 each if the file has none).
   */
  template <int dim>
  class PointCloudShape : public Shape<dim>
  {
  public:
    explicit PointCloudShape(const PointCloud<dim> &cloud);

    bool
    contains(const Vector<dim> &point) const override;

    /** From the nearest point, by looking at all. */
    SurfaceDistance<dim>
    surface_distance(const Vector<dim> &point) const override;

    BoundingBox<dim>
    bounding_box() const override;

    VolumeMoments<dim>
    volume_moments() const override;

    /** None: points fill nothing. */
    RegionMoments<dim>
    moments_within(const BoundingBox<dim> &box, const int depth = cell_depth<dim>) const override;

    /** The points, however far apart. */
    std::vector<Vector<dim>>
    surface_points(const double spacing) const override;

    const PointCloud<dim> &
    cloud() const
    {
      return all_points;
    }

  private:
    const PointCloud<dim> all_points;
  };
} // namespace magmpm
