#include <magmpm/geometry/mesh_interior.h>

#include <algorithm>
#include <cmath>

// Compiled with -ffp-contract=off: exchanging two points must change the sign of a product of theirs
// and nothing else.

namespace magmpm
{
  namespace
  {
    /** On which side of the origin the line from a to b runs in the yz-plane, never right through. */
    int
    side_of_origin(const Vector<3> &a, const Vector<3> &b, double &twice_area)
    {
      twice_area = a[1] * b[2] - b[1] * a[2];
      for (const double difference : {twice_area, a[2] - b[2], b[1] - a[1]})
        if (difference != 0.)
          return difference > 0. ? 1 : -1;
      return 0;
    }

    /** Whether the ray from the origin towards larger x crosses the triangle. */
    bool
    is_crossed(const Vector<3> &a, const Vector<3> &b, const Vector<3> &c)
    {
      double of_a, of_b, of_c; // weights of the corners: areas across from them
      const int side = side_of_origin(b, c, of_a);
      return side != 0 && side_of_origin(c, a, of_b) == side &&
             side_of_origin(a, b, of_c) == side &&
             (of_a * a[0] + of_b * b[0] + of_c * c[0]) / (of_a + of_b + of_c) > 0.;
    }
  } // namespace

  MeshInterior::MeshInterior(const TriangleMesh &mesh)
    : mesh(mesh)
    , box(bounding_box(mesh))
    , n_bins(std::clamp(static_cast<int>(std::sqrt(mesh.triangles.size())), 1, 512))
    , bin_begin(n_bins * n_bins + 1, 0)
  {
    for (int i = 0; i < 2; ++i)
      bin_size[i] = (box.upper[i + 1] - box.lower[i + 1]) / n_bins;
    for_each_bin([&](const int, const int bin) { ++bin_begin[bin + 1]; });
    for (int bin = 0; bin < n_bins * n_bins; ++bin)
      bin_begin[bin + 1] += bin_begin[bin];
    bin_triangles.resize(bin_begin.back());
    std::vector<std::size_t> next = bin_begin;
    for_each_bin([&](const int triangle, const int bin) { bin_triangles[next[bin]++] = triangle; });
  }

  int
  MeshInterior::bin_at(const double coordinate, const int axis) const
  {
    const double place = (coordinate - box.lower[axis]) / bin_size[axis - 1];
    return std::clamp(static_cast<int>(place), 0, n_bins - 1);
  }

  template <typename Visitor>
  void
  MeshInterior::for_each_bin(const Visitor &visit) const
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      {
        int first[2], last[2];
        for (int axis = 1; axis < 3; ++axis)
          {
            const auto [low, high] = std::minmax({mesh.points[mesh.triangles[t][0]][axis],
                                                  mesh.points[mesh.triangles[t][1]][axis],
                                                  mesh.points[mesh.triangles[t][2]][axis]});
            first[axis - 1]        = bin_at(low, axis);
            last[axis - 1]         = bin_at(high, axis);
          }
        for (int j = first[1]; j <= last[1]; ++j)
          for (int i = first[0]; i <= last[0]; ++i)
            visit(static_cast<int>(t), n_bins * j + i);
      }
  }

  bool
  MeshInterior::contains(const Vector<3> &point) const
  {
    for (int d = 0; d < 3; ++d)
      if (!(point[d] >= box.lower[d] && point[d] <= box.upper[d]))
        return false;
    const int bin  = n_bins * bin_at(point[2], 2) + bin_at(point[1], 1);
    bool is_inside = false;
    for (std::size_t i = bin_begin[bin]; i < bin_begin[bin + 1]; ++i)
      {
        const std::array<int, 3> &triangle = mesh.triangles[bin_triangles[i]];
        if (is_crossed(mesh.points[triangle[0]] - point,
                       mesh.points[triangle[1]] - point,
                       mesh.points[triangle[2]] - point))
          is_inside = !is_inside;
      }
    return is_inside;
  }
} // namespace magmpm
