#pragma once

#include <magmpm/geometry/triangle_mesh.h>

#include <cstddef>

namespace magmpm
{
  /** Points at the nodes of a grid with the same spacing along all axes. */
  struct SampleGrid
  {
    double spacing;  ///< [m]
    Vector<3> lower; ///< first point [m]
    int n[3];        ///< points along each axis

    /** Around a box, beyond it by @p margin spacings and less than half a spacing more. */
    SampleGrid(const BoundingBox<3> &box, const double spacing, const int margin);

    std::size_t
    size() const
    {
      return static_cast<std::size_t>(n[0]) * n[1] * n[2];
    }

    std::size_t
    index(const int i, const int j, const int k) const
    {
      return (static_cast<std::size_t>(k) * n[1] + j) * n[0] + i;
    }

    Vector<3>
    position(const int i, const int j, const int k) const
    {
      return lower + spacing * Vector<3>{{double(i), double(j), double(k)}};
    }
  };

  /**
   * The triangle nearest to each point of a grid, and the nearest point of it. Within 1.5 spacings of
   * a triangle it is the nearest; farther points take the nearest of those of their neighbours, so that
   * a distance d is too long by up to spacing^2/(8 d) where triangles are smaller than the spacing
   * (fast sweeping: Bridson, Fluid Simulation for Computer Graphics, 4.2). 10 to 20 times faster than
   * VTK's search for each point.
   */
  class NearestTriangles
  {
  public:
    NearestTriangles(const TriangleMesh &mesh, const SampleGrid &grid);

    /** The triangle nearest to the point of that index. */
    const std::array<int, 3> &
    triangle(const std::size_t index) const
    {
      return mesh.triangles[nearest[index]];
    }

    /** The point nearest to @p x, which is the point of the grid of that index. */
    Vector<3>
    nearest_point(const Vector<3> &x, const std::size_t index) const
    {
      return nearest_point_of(x, nearest[index]);
    }

  private:
    const TriangleMesh &mesh;
    const SampleGrid &grid;
    std::vector<int> nearest; ///< triangles
    std::vector<double> distance;

    Vector<3>
    nearest_point_of(const Vector<3> &x, const int triangle) const;

    /** Takes a triangle for a point if it is nearer than the one so far. */
    void
    offer(const Vector<3> &x, const std::size_t index, const int triangle);

    /** Offers each triangle to the points around it. */
    void
    offer_near();

    /** Offers to each point what its neighbours have, from one corner of the grid to another. */
    void
    sweep(const int direction);
  };
} // namespace magmpm
