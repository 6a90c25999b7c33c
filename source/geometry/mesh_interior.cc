#include <magmpm/geometry/column_moments.h>
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

    BoundingBox<3>
    reach_of(const std::array<Vector<3>, 3> &points)
    {
      BoundingBox<3> reach = {points[0], points[0]};
      for (const Vector<3> &point : points)
        for (int d = 0; d < 3; ++d)
          {
            reach.lower[d] = std::min(reach.lower[d], point[d]);
            reach.upper[d] = std::max(reach.upper[d], point[d]);
          }
      return reach;
    }

    bool
    meet(const BoundingBox<3> &a, const BoundingBox<3> &b)
    {
      for (int d = 0; d < 3; ++d)
        if (a.upper[d] < b.lower[d] || a.lower[d] > b.upper[d])
          return false;
      return true;
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

  MeshInterior::BinRange
  MeshInterior::bins_between(const Vector<3> &lower, const Vector<3> &upper) const
  {
    BinRange range;
    for (int axis = 1; axis < 3; ++axis)
      {
        range.first[axis - 1] = bin_at(lower[axis], axis);
        range.last[axis - 1]  = bin_at(upper[axis], axis);
      }
    return range;
  }

  std::array<Vector<3>, 3>
  MeshInterior::corners(const int triangle) const
  {
    const auto &[a, b, c] = mesh.triangles[triangle];
    return {{mesh.points[a], mesh.points[b], mesh.points[c]}};
  }

  MeshInterior::BinRange
  MeshInterior::bins_of(const int triangle) const
  {
    const BoundingBox<3> reach = reach_of(corners(triangle));
    return bins_between(reach.lower, reach.upper);
  }

  template <typename Visitor>
  void
  MeshInterior::for_each_bin(const Visitor &visit) const
  {
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      {
        const BinRange bins = bins_of(t);
        for (int j = bins.first[1]; j <= bins.last[1]; ++j)
          for (int i = bins.first[0]; i <= bins.last[0]; ++i)
            visit(t, n_bins * j + i);
      }
  }

  template <typename Visitor>
  void
  MeshInterior::for_each_triangle_across(const BoundingBox<3> &box, const Visitor &visit) const
  {
    const BinRange column = bins_between(box.lower, box.upper);
    for (int j = column.first[1]; j <= column.last[1]; ++j)
      for (int i = column.first[0]; i <= column.last[0]; ++i)
        for (std::size_t k = bin_begin[n_bins * j + i]; k < bin_begin[n_bins * j + i + 1]; ++k)
          {
            // A triangle in several bins of the column is met in the first of them.
            const BinRange bins = bins_of(bin_triangles[k]);
            if (i == std::max(bins.first[0], column.first[0]) &&
                j == std::max(bins.first[1], column.first[1]))
              visit(bin_triangles[k]);
          }
  }

  RegionMoments<3>
  MeshInterior::moments_within(const BoundingBox<3> &cell) const
  {
    bool is_cut = false, may_be_filled = true;
    for (int d = 0; d < 3; ++d)
      may_be_filled = may_be_filled && cell.upper[d] > box.lower[d] && cell.lower[d] < box.upper[d];
    if (!may_be_filled)
      return {};
    for_each_triangle_across(cell, [&](const int triangle) {
      is_cut = is_cut || meet(reach_of(corners(triangle)), cell);
    });
    if (!is_cut)
      return contains(middle_of(cell)) ? moments_of(cell) : RegionMoments<3>();
    ColumnMoments<3> column(cell);
    for_each_triangle_across(cell, [&](const int triangle) { column.add(corners(triangle)); });
    return column.moments();
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
