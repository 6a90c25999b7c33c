#pragma once

#include <magmpm/geometry/mesh_interior.h>
#include <magmpm/geometry/nearest_triangles.h>

namespace magmpm
{
  /**
   * Signed distance from a closed mesh and its normal, sampled on a grid and interpolated linearly
   * along each axis.
   *
   * Between samples (NearestTriangles) the distance errs by about 3 h^2/(8 R) where the surface is
   * curved with radius R, by up to 0.4 h at sharp edges and 0.6 h in the middle between two walls;
   * the normal turns over an edge within h.
   *
   * Beyond the grid, which goes 3 h farther than the mesh, the distance is the one from the surface
   * point that is nearest to the nearest point of the grid: never too short, and too long by a part
   * of itself that the test of it prints (5 % at two radii from a sphere).
   */
  class DistanceSamples
  {
  public:
    /**
     * @param mesh     closed.
     * @param spacing  of the samples, h [m].
     */
    DistanceSamples(const TriangleMesh &mesh, const MeshInterior &interior, const double spacing);

    SurfaceDistance<3>
    at(const Vector<3> &point) const;

    std::size_t
    size() const
    {
      return samples.size();
    }

  private:
    /** A distance [m] and a normal: four numbers, which fill a register. */
    using Sample = Vector<4, float>;

    const SampleGrid grid;
    std::vector<Sample> samples;

    /** Within the grid. */
    SurfaceDistance<3>
    inside(const Vector<3> &point) const;
  };
} // namespace magmpm
