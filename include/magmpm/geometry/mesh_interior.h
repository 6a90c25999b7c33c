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

    /**
     * Moments, about the middle of @p cell, of what the mesh encloses in it: exact (ColumnMoments), where
     * no triangle comes near by one look whether the middle is inside.
     */
    RegionMoments<3>
    moments_within(const BoundingBox<3> &cell) const;

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

    /** Bins along y and along z. */
    struct BinRange
    {
      int first[2], last[2];
    };

    /** Those between two places across x. */
    BinRange
    bins_between(const Vector<3> &lower, const Vector<3> &upper) const;

    /** Those that a triangle may be in. */
    BinRange
    bins_of(const int triangle) const;

    /** Calls @p visit with each pair of triangle and bin that it may be in. */
    template <typename Visitor>
    void
    for_each_bin(const Visitor &visit) const;

    /** Calls @p visit with each triangle, once, that may be in the column through @p box along x. */
    template <typename Visitor>
    void
    for_each_triangle_across(const BoundingBox<3> &box, const Visitor &visit) const;

    std::array<Vector<3>, 3>
    corners(const int triangle) const;
  };
} // namespace magmpm
