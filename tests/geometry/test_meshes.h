#pragma once

#include <magmpm/geometry/triangle_mesh.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <string>

/** Meshes whose geometry is known, and files of them. */
namespace magmpm::testing
{
  /** The unit cube, its corners at 0 and 1, in 12 triangles. */
  inline TriangleMesh
  unit_cube()
  {
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
      mesh.points.push_back({{double(i & 1), double((i >> 1) & 1), double(i >> 2)}});
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
