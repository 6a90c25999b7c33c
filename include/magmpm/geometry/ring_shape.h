#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /** A torus: what a disc sweeps out round an axis in its plane, which does not cross it. */
  class RingShape : public Shape<3>
  {
  public:
    /**
     * @param centre  in the middle of the hole [m].
     * @param axis    through the hole, of any length but 0.
     * @param outer_radius, inner_radius  from the axis to the farthest and nearest points [m].
     */
    RingShape(const Vector<3> &centre,
              const Vector<3> &axis,
              const double outer_radius,
              const double inner_radius);

    bool
    contains(const Vector<3> &point) const override;

    SurfaceDistance<3>
    surface_distance(const Vector<3> &point) const override;

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
    const Vector<3> direction;     ///< of the axis, of length 1
    const Vector<3> across, other; ///< of length 1, at right angles to the axis and each other
    const double middle_radius;    ///< from the axis to the middle of the disc [m]
    const double disc_radius;      ///< [m]

    /** A point of the surface. @param around, in_disc  angles about the axis and in the disc [rad]. */
    Vector<3>
    surface_point(const double around, const double in_disc) const;
  };
} // namespace magmpm
