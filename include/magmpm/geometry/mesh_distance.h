#pragma once

#include <magmpm/geometry/triangle_mesh.h>

#include <memory>

namespace magmpm
{
  /**
   * The exact signed distance from a closed mesh whose triangles are turned outward: VTK's
   * vtkImplicitPolyDataDistance, which finds the nearest triangle, and on sides and corners of
   * triangles takes the side from their angle-weighted normal (Baerentzen and Aanaes 2005). Some
   * microseconds per point. Not to be asked by several threads at once.
   */
  class MeshDistance
  {
  public:
    explicit MeshDistance(const TriangleMesh &mesh);
    ~MeshDistance();

    SurfaceDistance<3>
    at(const Vector<3> &point) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace magmpm
