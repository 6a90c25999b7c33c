#include <magmpm/geometry/triangle_mesh.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  void
  transform(const double scale,
            const Matrix<3> &rotation,
            const Vector<3> &translation,
            TriangleMesh &mesh)
  {
    for (Vector<3> &point : mesh.points)
      point = translation + rotation * (scale * point);
  }

  BoundingBox<3>
  bounding_box(const TriangleMesh &mesh)
  {
    BoundingBox<3> box = {mesh.points.front(), mesh.points.front()};
    for (const Vector<3> &point : mesh.points)
      for (int d = 0; d < 3; ++d)
        {
          box.lower[d] = std::min(box.lower[d], point[d]);
          box.upper[d] = std::max(box.upper[d], point[d]);
        }
    return box;
  }

  VolumeMoments<3>
  volume_moments(const TriangleMesh &mesh)
  {
    // Sums over the tetrahedra between the triangles and a point amid them, so that little cancels.
    const BoundingBox<3> box = bounding_box(mesh);
    const Vector<3> middle   = 0.5 * (box.lower + box.upper);
    double volume            = 0.;
    Vector<3> first;
    Matrix<3> second;
    for (const std::array<int, 3> &triangle : mesh.triangles)
      {
        const Vector<3> a       = mesh.points[triangle[0]] - middle;
        const Vector<3> b       = mesh.points[triangle[1]] - middle;
        const Vector<3> c       = mesh.points[triangle[2]] - middle;
        const Vector<3> sum     = a + b + c;
        const double tetrahedra = dot(a, cross(b, c)); // six times the volume
        volume += tetrahedra / 6.;
        first += (tetrahedra / 24.) * sum;
        second += (tetrahedra / 120.) * (outer(a, a) + outer(b, b) + outer(c, c) + outer(sum, sum));
      }
    const Vector<3> centroid = (1. / volume) * first;
    return {volume, middle + centroid, second + (-volume) * outer(centroid, centroid)};
  }

  std::vector<Vector<3>>
  surface_points(const TriangleMesh &mesh, const double spacing)
  {
    std::vector<Vector<3>> points = mesh.points;
    for (const std::array<int, 3> &triangle : mesh.triangles)
      {
        const Vector<3> &a   = mesh.points[triangle[0]];
        const Vector<3> ab   = mesh.points[triangle[1]] - a;
        const Vector<3> ac   = mesh.points[triangle[2]] - a;
        const double longest = std::max({norm(ab), norm(ac), norm(ac - ab)});
        const int n          = static_cast<int>(std::ceil(longest / spacing));
        for (int i = 0; i <= n; ++i)
          for (int j = 0; i + j <= n; ++j)
            if (i != n && j != n && i + j != 0)
              points.push_back(a + (static_cast<double>(i) / n) * ab +
                               (static_cast<double>(j) / n) * ac);
      }
    return points;
  }
} // namespace magmpm
