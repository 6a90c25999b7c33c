#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /** A sphere; a disc in 2D. */
  template <int dim>
  class SphereShape : public Shape<dim>
  {
  public:
    /** @param radius  greater than 0 [m]. */
    SphereShape(const Vector<dim> &centre, const double radius);

    bool
    contains(const Vector<dim> &point) const override;

    SurfaceDistance<dim>
    surface_distance(const Vector<dim> &point) const override;

    BoundingBox<dim>
    bounding_box() const override;

    VolumeMoments<dim>
    volume_moments() const override;

    std::vector<Vector<dim>>
    surface_points(const double spacing) const override;

    SurfaceMesh<dim>
    surface_mesh(const double spacing) const override;

  private:
    const Vector<dim> centre;
    const double radius;
  };
} // namespace magmpm
