#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /** A circular cylinder with flat ends, its axis in any direction. */
  class CylinderShape : public Shape<3>
  {
  public:
    /**
     * @param centre  middle of the axis [m].
     * @param axis    its direction, of any length but 0.
     * @param radius  greater than 0 [m].
     * @param length  along the axis, greater than 0 [m].
     */
    CylinderShape(const Vector<3> &centre,
                  const Vector<3> &axis,
                  const double radius,
                  const double length);

    bool
    contains(const Vector<3> &point) const override;

    SurfaceDistance<3>
    surface_distance(const Vector<3> &point) const override;

    /** By the mantle and both ends. */
    std::vector<WayOut<3>>
    ways_out(const Vector<3> &point) const override;

    BoundingBox<3>
    bounding_box() const override;

    VolumeMoments<3>
    volume_moments() const override;

    std::vector<Vector<3>>
    surface_points(const double spacing) const override;

    SurfaceMesh<3>
    surface_mesh(const double spacing) const override;

  private:
    const Vector<3> centre;
    const Vector<3> direction; ///< of the axis, of length 1
    const Vector<3> across;    ///< of length 1, at a right angle to the axis
    const double radius, length;
  };
} // namespace magmpm
