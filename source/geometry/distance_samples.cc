#include <magmpm/geometry/distance_samples.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    constexpr int margin = 3; // samples around the box

    /** Signed, with the normal of the triangle itself where the point is on it. */
    SurfaceDistance<3>
    signed_distance(const TriangleMesh &mesh,
                    const std::array<int, 3> &triangle,
                    const Vector<3> &from_nearest,
                    const bool is_inside)
    {
      const Vector<3> &a    = mesh.points[triangle[0]];
      const Vector<3> ab    = mesh.points[triangle[1]] - a;
      const Vector<3> ac    = mesh.points[triangle[2]] - a;
      const Vector<3> area  = cross(ab, ac);
      const double distance = norm(from_nearest);
      if (distance < 1e-6 * std::sqrt(norm(area)))
        return {0., (1. / norm(area)) * area};
      const double sign = is_inside ? -1. : 1.;
      return {sign * distance, (sign / distance) * from_nearest};
    }
  } // namespace

  DistanceSamples::DistanceSamples(const TriangleMesh &mesh,
                                   const MeshInterior &interior,
                                   const double spacing)
    : grid(bounding_box(mesh), spacing, margin)
  {
    const NearestTriangles nearest(mesh, grid);
    samples.reserve(grid.size());
    for (int k = 0; k < grid.n[2]; ++k)
      for (int j = 0; j < grid.n[1]; ++j)
        for (int i = 0; i < grid.n[0]; ++i)
          {
            const Vector<3> x             = grid.position(i, j, k);
            const std::size_t index       = grid.index(i, j, k);
            const SurfaceDistance<3> here = signed_distance(mesh,
                                                            nearest.triangle(index),
                                                            x - nearest.nearest_point(x, index),
                                                            interior.contains(x));
            samples.push_back({{static_cast<float>(here.distance),
                                static_cast<float>(here.normal[0]),
                                static_cast<float>(here.normal[1]),
                                static_cast<float>(here.normal[2])}});
          }
  }

  SurfaceDistance<3>
  DistanceSamples::inside(const Vector<3> &point) const
  {
    int cell[3];
    float part[3];
    for (int d = 0; d < 3; ++d)
      {
        const double place = (point[d] - grid.lower[d]) / grid.spacing;
        cell[d]            = std::clamp(static_cast<int>(place), 0, grid.n[d] - 2);
        part[d]            = static_cast<float>(place - cell[d]);
      }
    const Sample *corner = samples.data() + grid.index(cell[0], cell[1], cell[2]);
    const auto along_x   = [&](const Sample *at) { return at[0] + part[0] * (at[1] - at[0]); };
    const auto along_y   = [&](const Sample *at) {
      const Sample low = along_x(at);
      return low + part[1] * (along_x(at + grid.index(0, 1, 0)) - low);
    };
    const Sample low   = along_y(corner);
    const Sample value = low + part[2] * (along_y(corner + grid.index(0, 0, 1)) - low);

    Vector<3> normal    = {{value[1], value[2], value[3]}};
    const double length = norm(normal);
    // Opposite normals, amid two walls: one of them will do.
    if (length > 1e-3)
      return {value[0], (1. / length) * normal};
    normal = {{(*corner)[1], (*corner)[2], (*corner)[3]}};
    return {value[0], (1. / norm(normal)) * normal};
  }

  SurfaceDistance<3>
  DistanceSamples::at(const Vector<3> &point) const
  {
    Vector<3> nearest = point;
    for (int d = 0; d < 3; ++d)
      nearest[d] =
        std::clamp(point[d], grid.lower[d], grid.lower[d] + (grid.n[d] - 1) * grid.spacing);
    const SurfaceDistance<3> there = inside(nearest);
    const Vector<3> beyond         = point - nearest;
    if (norm_square(beyond) == 0.)
      return there;

    const Vector<3> from_surface = beyond + there.distance * there.normal;
    const double distance        = norm(from_surface);
    return {distance, (1. / distance) * from_surface};
  }
} // namespace magmpm
