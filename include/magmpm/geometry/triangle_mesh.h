#pragma once

#include <magmpm/geometry/shape.h>

#include <array>

namespace magmpm
{
  /** Triangles, their corners counterclockwise seen from outside of what they enclose. */
  struct TriangleMesh
  {
    std::vector<Vector<3>> points; ///< [m]
    std::vector<std::array<int, 3>> triangles;
  };

  /** x -> translation + rotation (scale x) of all points. @param scale  greater than 0. */
  void
  transform(const double scale,
            const Matrix<3> &rotation,
            const Vector<3> &translation,
            TriangleMesh &mesh);

  BoundingBox<3>
  bounding_box(const TriangleMesh &mesh);

  /** Of the inside of a closed mesh, by the divergence theorem; exact. */
  VolumeMoments<3>
  volume_moments(const TriangleMesh &mesh);

  /** The corners, and on sides and triangles as many points as keep neighbours within @p spacing. */
  std::vector<Vector<3>>
  surface_points(const TriangleMesh &mesh, const double spacing);
} // namespace magmpm
