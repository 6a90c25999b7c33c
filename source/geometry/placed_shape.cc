#include <magmpm/geometry/placed_shape.h>

namespace magmpm
{
  template <int dim>
  PlacedShape<dim>::PlacedShape(const Shape<dim> &shape, const Pose<dim> &pose)
    : shape(shape)
    , pose(pose)
  {
  }

  template <int dim>
  bool
  PlacedShape<dim>::contains(const Vector<dim> &point) const
  {
    return shape.contains(pose.to_own(point));
  }

  template <int dim>
  SurfaceDistance<dim>
  PlacedShape<dim>::surface_distance(const Vector<dim> &point) const
  {
    SurfaceDistance<dim> result = shape.surface_distance(pose.to_own(point));
    result.normal               = pose.rotation * result.normal;
    return result;
  }

  template <int dim>
  BoundingBox<dim>
  PlacedShape<dim>::bounding_box() const
  {
    const BoundingBox<dim> own = shape.bounding_box();
    const Vector<dim> middle   = pose.to_world(0.5 * (own.lower + own.upper));
    const Vector<dim> half     = 0.5 * (own.upper - own.lower);
    Vector<dim> reach;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        reach[i] += std::abs(pose.rotation(i, j)) * half[j];
    return {middle - reach, middle + reach};
  }

  template <int dim>
  VolumeMoments<dim>
  PlacedShape<dim>::volume_moments() const
  {
    const VolumeMoments<dim> own = shape.volume_moments();
    return {own.volume,
            pose.to_world(own.centroid),
            pose.rotation * (own.second * transpose(pose.rotation))};
  }

  template <int dim>
  std::vector<Vector<dim>>
  PlacedShape<dim>::surface_points(const double spacing) const
  {
    std::vector<Vector<dim>> points = shape.surface_points(spacing);
    for (Vector<dim> &point : points)
      point = pose.to_world(point);
    return points;
  }

  template class PlacedShape<2>;
  template class PlacedShape<3>;
} // namespace magmpm
