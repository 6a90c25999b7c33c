#pragma once

#include <magmpm/base/constants.h>
#include <magmpm/geometry/triangle_mesh.h>

#include <cmath>

/** Closed meshes for tests, their triangles turned outward. */
namespace magmpm::testing
{
  inline TriangleMesh
  box_mesh(const Vector<3> &lower, const Vector<3> &upper)
  {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
      mesh.points.push_back(
        {{i & 1 ? upper[0] : lower[0], i & 2 ? upper[1] : lower[1], i & 4 ? upper[2] : lower[2]}});
    mesh.triangles = {{0, 2, 3},
                      {0, 3, 1},
                      {4, 5, 7},
                      {4, 7, 6},
                      {0, 1, 5},
                      {0, 5, 4},
                      {2, 6, 7},
                      {2, 7, 3},
                      {0, 4, 6},
                      {0, 6, 2},
                      {1, 3, 7},
                      {1, 7, 5}};
    return mesh;
  }

  /**
   * What a curve from the axis to the axis sweeps out when it turns round z, in @p n steps: (rho, z) of
   * its points, from the lowest to the highest; the first and last ones lie on the axis.
   */
  inline TriangleMesh
  turned_mesh(const std::vector<Vector<2>> &curve, const int n)
  {
    TriangleMesh mesh;
    const int n_rings = static_cast<int>(curve.size()) - 2;
    for (int ring = 1; ring <= n_rings; ++ring)
      for (int i = 0; i < n; ++i)
        {
          const double angle = 2. * constants::pi * i / n;
          mesh.points.push_back(
            {{curve[ring][0] * std::cos(angle), curve[ring][0] * std::sin(angle), curve[ring][1]}});
        }
    const int bottom = n * n_rings, top = bottom + 1;
    mesh.points.push_back({{0., 0., curve.front()[1]}});
    mesh.points.push_back({{0., 0., curve.back()[1]}});
    for (int i = 0; i < n; ++i)
      {
        const int next = (i + 1) % n;
        mesh.triangles.push_back({bottom, next, i});
        for (int ring = 0; ring + 1 < n_rings; ++ring)
          {
            const int below = ring * n, above = below + n;
            mesh.triangles.push_back({below + i, below + next, above + next});
            mesh.triangles.push_back({below + i, above + next, above + i});
          }
        mesh.triangles.push_back({(n_rings - 1) * n + i, (n_rings - 1) * n + next, top});
      }
    return mesh;
  }

  /** A sphere of radius 1: 2 n meridians, n zones. */
  inline TriangleMesh
  sphere_mesh(const int n)
  {
    std::vector<Vector<2>> curve;
    for (int i = 0; i <= n; ++i)
      {
        const double latitude = constants::pi * i / n;
        curve.push_back({{std::sin(latitude), -std::cos(latitude)}});
      }
    return turned_mesh(curve, 2 * n);
  }

  /** A cylinder as the class Cylinder has it, with @p n sides. */
  inline TriangleMesh
  cylinder_mesh(const double radius, const double length, const int n)
  {
    const double h = 0.5 * length;
    return turned_mesh({{{0., -h}}, {{radius, -h}}, {{radius, h}}, {{0., h}}}, n);
  }
} // namespace magmpm::testing
