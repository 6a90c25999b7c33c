#pragma once

#include <magmpm/base/constants.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <string>

/** Meshes whose geometry is known, and files of them. */
namespace magmpm::testing
{
  /** A box in 12 triangles: the surface of a BoxShape, which tests of its own hold. */
  inline TriangleMesh
  box_mesh(const Vector<3> &lower, const Vector<3> &upper)
  {
    const SurfaceMesh<3> surface = BoxShape<3>(lower, upper).surface_mesh(1.);
    return {surface.points, surface.facets};
  }

  /** The unit cube, its corners at 0 and 1. */
  inline TriangleMesh
  unit_cube()
  {
    return box_mesh({}, {{1., 1., 1.}});
  }

  /** An icosahedron whose triangles were cut in four so many times, corners on the unit sphere. */
  inline TriangleMesh
  unit_sphere(const int n_refinements)
  {
    const double t = 0.5 * (1. + std::sqrt(5.));
    TriangleMesh mesh;
    mesh.points    = {{{-1, t, 0}},
                      {{1, t, 0}},
                      {{-1, -t, 0}},
                      {{1, -t, 0}},
                      {{0, -1, t}},
                      {{0, 1, t}},
                      {{0, -1, -t}},
                      {{0, 1, -t}},
                      {{t, 0, -1}},
                      {{t, 0, 1}},
                      {{-t, 0, -1}},
                      {{-t, 0, 1}}};
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (Vector<3> &point : mesh.points)
      point = (1. / norm(point)) * point;
    for (int i = 0; i < n_refinements; ++i)
      {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](const int a, const int b) {
          const auto [entry, is_new] = middles.emplace(std::minmax(a, b),
                                                       static_cast<int>(mesh.points.size()));
          if (is_new)
            {
              const Vector<3> sum = mesh.points[a] + mesh.points[b];
              mesh.points.push_back((1. / norm(sum)) * sum);
            }
          return entry->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto &[a, b, c] : mesh.triangles)
          {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
          }
        mesh.triangles = finer;
      }
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

  inline TriangleMesh
  moved(TriangleMesh mesh, const double scale, const Vector<3> &translation)
  {
    transform(scale, identity<3>(), translation, mesh);
    return mesh;
  }

  inline TriangleMesh
  turned_over(TriangleMesh mesh)
  {
    for (std::array<int, 3> &triangle : mesh.triangles)
      std::swap(triangle[0], triangle[1]);
    return mesh;
  }

  /** Both meshes in one. */
  inline TriangleMesh
  joined(TriangleMesh a, const TriangleMesh &b)
  {
    const int n = static_cast<int>(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto &[i, j, k] : b.triangles)
      a.triangles.push_back({i + n, j + n, k + n});
    return a;
  }

  /** STL in words: each triangle with corners of its own, of seven digits, and without normals. */
  inline void
  write_stl(const std::string &file, const TriangleMesh &mesh)
  {
    std::ofstream stream(file);
    stream.precision(7);
    stream << "solid test\n";
    for (const auto &triangle : mesh.triangles)
      {
        stream << "facet normal 0 0 0\nouter loop\n";
        for (const int i : triangle)
          stream << "vertex " << mesh.points[i][0] << ' ' << mesh.points[i][1] << ' '
                 << mesh.points[i][2] << '\n';
        stream << "endloop\nendfacet\n";
      }
    stream << "endsolid test\n";
  }

  inline void
  write_obj(const std::string &file, const TriangleMesh &mesh)
  {
    std::ofstream stream(file);
    stream.precision(17);
    for (const Vector<3> &point : mesh.points)
      stream << "v " << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
    for (const auto &[a, b, c] : mesh.triangles)
      stream << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }

  inline void
  write_ply(const std::string &file, const TriangleMesh &mesh)
  {
    std::ofstream stream(file);
    stream.precision(17);
    stream << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
           << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
           << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vector<3> &point : mesh.points)
      stream << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
    for (const auto &[a, b, c] : mesh.triangles)
      stream << "3 " << a << ' ' << b << ' ' << c << '\n';
  }
} // namespace magmpm::testing
