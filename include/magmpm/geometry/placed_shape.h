#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/motion/pose.h>

namespace magmpm
{
  /** A shape somewhere else: seen from the world, where another one lies in its own frame. */
  template <int dim>
  class PlacedShape : public Shape<dim>
  {
  public:
    /** @param shape  must outlive this. */
    PlacedShape(const Shape<dim> &shape, const Pose<dim> &pose);

    bool
    contains(const Vector<dim> &point) const override;

    SurfaceDistance<dim>
    surface_distance(const Vector<dim> &point) const override;

    /** The smallest box around the turned box of the shape. */
    BoundingBox<dim>
    bounding_box() const override;

    VolumeMoments<dim>
    volume_moments() const override;

    std::vector<Vector<dim>>
    surface_points(const double spacing) const override;

  private:
    const Shape<dim> &shape;
    const Pose<dim> pose;
  };
} // namespace magmpm
