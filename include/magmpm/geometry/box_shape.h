#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /** A box with edges along the axes; a rectangle in 2D. */
  template <int dim>
  class BoxShape : public Shape<dim>
  {
  public:
    /** Corners [m]; each edge longer than 0. */
    BoxShape(const Vector<dim> &lower_corner, const Vector<dim> &upper_corner);

    bool
    contains(const Vector<dim> &point) const override;

    SurfaceDistance<dim>
    surface_distance(const Vector<dim> &point) const override;

    /** One on each face, weighted with depth^-2. */
    std::vector<WayOut<dim>>
    ways_out(const Vector<dim> &point) const override;

    BoundingBox<dim>
    bounding_box() const override;

    VolumeMoments<dim>
    volume_moments() const override;

    /** Exact. */
    RegionMoments<dim>
    moments_within(const BoundingBox<dim> &cell, const int depth = cell_depth<dim>) const override;

    std::vector<Vector<dim>>
    surface_points(const double spacing) const override;

    SurfaceMesh<dim>
    surface_mesh(const double spacing) const override;

  private:
    const BoundingBox<dim> box;
  };
} // namespace magmpm
