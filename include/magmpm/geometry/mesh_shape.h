#pragma once

#include <magmpm/geometry/mesh_interior.h>
#include <magmpm/geometry/shape.h>
#include <magmpm/geometry/triangle_mesh.h>

#include <memory>

namespace magmpm
{
  class DistanceSamples;

  /**
   * The inside of a closed triangle mesh.
   *
   * Which points it contains, its box, moments (also those of a part) and surface points are exact. Distances come from
   * samples on a grid (DistanceSamples, which says how far they err), taken when the first is asked
   * for, so that a shape that only seeds a body does without. Not to be asked by several threads at
   * once.
   */
  class MeshShape : public Shape<3>
  {
  public:
    /**
     * @param mesh            closed, with its triangles turned outward.
     * @param sample_spacing  of the distances [m]; 0: a 64th of the longest edge of the bounding box,
     *                        or more, so that there are no more than some 300,000 samples.
     */
    MeshShape(const TriangleMesh &mesh, const double sample_spacing = 0.);
    ~MeshShape() override;

    bool
    contains(const Vector<3> &point) const override;

    SurfaceDistance<3>
    surface_distance(const Vector<3> &point) const override;

    BoundingBox<3>
    bounding_box() const override;

    VolumeMoments<3>
    volume_moments() const override;

    /** Exact. */
    RegionMoments<3>
    moments_within(const BoundingBox<3> &cell, const int depth = cell_depth<3>) const override;

    std::vector<Vector<3>>
    surface_points(const double spacing) const override;

    SurfaceMesh<3>
    surface_mesh(const double spacing) const override;

    const TriangleMesh &
    mesh() const
    {
      return triangles;
    }

  private:
    const TriangleMesh triangles;
    const BoundingBox<3> box;
    const double sample_spacing;
    const MeshInterior interior;
    mutable std::unique_ptr<DistanceSamples> samples;
  };
} // namespace magmpm
