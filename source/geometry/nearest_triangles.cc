#include <magmpm/geometry/nearest_on_triangle.h>
#include <magmpm/geometry/nearest_triangles.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace magmpm
{
  SampleGrid::SampleGrid(const BoundingBox<3> &box, const double spacing, const int margin)
    : spacing(spacing)
  {
    for (int d = 0; d < 3; ++d)
      {
        const double extent = box.upper[d] - box.lower[d];
        n[d]                = static_cast<int>(std::ceil(extent / spacing)) + 1 + 2 * margin;
        lower[d]            = box.lower[d] - 0.5 * ((n[d] - 1) * spacing - extent);
      }
  }

  NearestTriangles::NearestTriangles(const TriangleMesh &mesh, const SampleGrid &grid)
    : mesh(mesh)
    , grid(grid)
    , nearest(grid.size(), -1)
    , distance(grid.size(), std::numeric_limits<double>::infinity())
  {
    offer_near();
    for (int direction = 0; direction < 8; ++direction)
      sweep(direction);
  }

  Vector<3>
  NearestTriangles::nearest_point_of(const Vector<3> &x, const int triangle) const
  {
    const std::array<int, 3> &corners = mesh.triangles[triangle];
    return nearest_on_triangle(
      x, mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]);
  }

  void
  NearestTriangles::offer(const Vector<3> &x, const std::size_t index, const int triangle)
  {
    if (triangle < 0 || triangle == nearest[index])
      return;
    const double new_distance = norm(x - nearest_point_of(x, triangle));
    if (new_distance < distance[index])
      {
        distance[index] = new_distance;
        nearest[index]  = triangle;
      }
  }

  void
  NearestTriangles::offer_near()
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      {
        const std::array<int, 3> &corners = mesh.triangles[t];
        int first[3], last[3];
        for (int d = 0; d < 3; ++d)
          {
            const auto [low, high] = std::minmax(
              {mesh.points[corners[0]][d], mesh.points[corners[1]][d], mesh.points[corners[2]][d]});
            const auto place = [&](const double x) {
              return static_cast<int>(std::floor((x - grid.lower[d]) / grid.spacing));
            };
            first[d] = std::max(0, place(low) - 1);
            last[d]  = std::min(grid.n[d] - 1, place(high) + 2);
          }
        for (int k = first[2]; k <= last[2]; ++k)
          for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i)
              offer(grid.position(i, j, k), grid.index(i, j, k), static_cast<int>(t));
      }
  }

  void
  NearestTriangles::sweep(const int direction)
  {
    int step[3];
    for (int d = 0; d < 3; ++d)
      step[d] = (direction >> d) & 1 ? -1 : 1;
    const auto at = [&](const int d, const int count) {
      return step[d] > 0 ? count : grid.n[d] - 1 - count;
    };
    for (int c = 0; c < grid.n[2]; ++c)
      for (int b = 0; b < grid.n[1]; ++b)
        for (int a = 0; a < grid.n[0]; ++a)
          {
            const int i = at(0, a), j = at(1, b), k = at(2, c);
            const Vector<3> x       = grid.position(i, j, k);
            const std::size_t index = grid.index(i, j, k);
            for (int neighbour = 1; neighbour < 8; ++neighbour)
              {
                const int back[3] = {neighbour & 1, (neighbour >> 1) & 1, neighbour >> 2};
                if (a >= back[0] && b >= back[1] && c >= back[2])
                  offer(x,
                        index,
                        nearest[grid.index(
                          i - step[0] * back[0], j - step[1] * back[1], k - step[2] * back[2])]);
              }
          }
  }
} // namespace magmpm
