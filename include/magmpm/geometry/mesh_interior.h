#pragma once

#include <magmpm/geometry/triangle_mesh.h>

#include <cstddef>

namespace magmpm
{
  /**
   * Which points lie inside a closed mesh: those from which a ray along x crosses it an odd number of
   * times. A ray through a side or a corner of triangles counts as one a little aside, for all
   * triangles there alike (simulation of simplicity, Edelsbrunner and Muecke 1990), so that the answer
   * is right for every point but those within rounding of the surface. Triangles are found by their
   * place across x.
   */
  class MeshInterior
  {
  public:
    /** @param mesh  closed; must live as long as this object. */
    explicit MeshInterior(const TriangleMesh &mesh);

    bool
    contains(const Vector<3> &point) const;

  private:
    const TriangleMesh &mesh;
    const BoundingBox<3> box;
    int n_bins;         ///< along y, and along z
    double bin_size[2]; ///< along y and z [m]
    std::vector<std::size_t> bin_begin;
    std::vector<int> bin_triangles; ///< those of bin b: bin_begin[b] to bin_begin[b + 1]

    /** The bin of a coordinate y (axis 1) or z (axis 2). */
    int
    bin_at(const double coordinate, const int axis) const;

    /** Calls @p visit with each pair of triangle and bin that it may be in. */
    template <typename Visitor>
    void
    for_each_bin(const Visitor &visit) const;
  };
} // namespace magmpm
