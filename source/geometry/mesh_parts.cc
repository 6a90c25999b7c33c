#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/mesh_interior.h>
#include <magmpm/geometry/mesh_parts.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace magmpm
{
  namespace
  {
    using Edge = std::pair<int, int>; ///< points, the lower one first

    void
    turn_over(std::array<int, 3> &triangle)
    {
      std::swap(triangle[1], triangle[2]);
    }

    /** Whether a triangle runs through @p edge from its lower to its higher point. */
    bool
    runs_upward(const std::array<int, 3> &triangle, const Edge &edge)
    {
      for (int i = 0; i < 3; ++i)
        if (triangle[i] == edge.first && triangle[(i + 1) % 3] == edge.second)
          return true;
      return false;
    }

    Edge
    edge_of(const std::array<int, 3> &triangle, const int i)
    {
      return std::minmax({triangle[i], triangle[(i + 1) % 3]});
    }

    /** Goes over the sides of triangles from each to the next, as long as it gets to new ones. */
    class PartSearch
    {
    public:
      explicit PartSearch(TriangleMesh &mesh)
        : mesh(mesh)
        , was_reached(mesh.triangles.size(), false)
      {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
          for (int i = 0; i < 3; ++i)
            triangles_at[edge_of(mesh.triangles[t], i)].push_back(t);
      }

      /** Turns the triangles that hang together with @p start the way it is and returns them. */
      std::vector<std::size_t>
      part_with(const std::size_t start)
      {
        std::vector<std::size_t> part = {start};
        was_reached[start]            = true;
        for (std::size_t next = 0; next < part.size(); ++next)
          for (int i = 0; i < 3; ++i)
            {
              const std::array<int, 3> from = mesh.triangles[part[next]];
              const Edge edge               = edge_of(from, i);
              for (const std::size_t other : triangles_at[edge])
                if (other != part[next])
                  turn_like(from, edge, other, part);
            }
        return part;
      }

      bool
      has_reached(const std::size_t triangle) const
      {
        return was_reached[triangle];
      }

    private:
      TriangleMesh &mesh;
      std::vector<bool> was_reached;
      std::map<Edge, std::vector<std::size_t>> triangles_at;

      void
      turn_like(const std::array<int, 3> &from,
                const Edge &edge,
                const std::size_t other,
                std::vector<std::size_t> &part)
      {
        const bool alike = runs_upward(from, edge) != runs_upward(mesh.triangles[other], edge);
        if (was_reached[other])
          {
            if (!alike)
              throw InputError("the surface has only one side, so nothing is inside of it. "
                               "A body needs a surface that encloses it.");
            return;
          }
        was_reached[other] = true;
        part.push_back(other);
        if (!alike)
          turn_over(mesh.triangles[other]);
      }
    };

    /** The triangles @p part of a mesh, as a mesh of its own. */
    TriangleMesh
    extracted(const TriangleMesh &mesh, const std::vector<std::size_t> &part)
    {
      TriangleMesh result;
      std::map<int, int> new_number;
      for (const std::size_t t : part)
        {
          std::array<int, 3> triangle = mesh.triangles[t];
          for (int &point : triangle)
            {
              const auto [entry, is_new] =
                new_number.emplace(point, static_cast<int>(result.points.size()));
              if (is_new)
                result.points.push_back(mesh.points[point]);
              point = entry->second;
            }
          result.triangles.push_back(triangle);
        }
      return result;
    }

    bool
    boxes_meet(const BoundingBox<3> &a, const BoundingBox<3> &b)
    {
      for (int d = 0; d < 3; ++d)
        if (a.lower[d] > b.upper[d] || b.lower[d] > a.upper[d])
          return false;
      return true;
    }

    /** Whether the part @p inner lies inside of the part @p outer. @throw InputError if they cross. */
    bool
    encloses(const TriangleMesh &outer, const TriangleMesh &inner)
    {
      if (!boxes_meet(bounding_box(outer), bounding_box(inner)))
        return false;
      const MeshInterior interior(outer);
      const auto is_inside  = [&](const Vector<3> &point) { return interior.contains(point); };
      const bool any_inside = std::any_of(inner.points.begin(), inner.points.end(), is_inside);
      if (any_inside && !std::all_of(inner.points.begin(), inner.points.end(), is_inside))
        throw InputError("the mesh consists of parts that are closed each but cross one another. "
                         "Unite them to one surface (Blender: Boolean > Union).");
      return any_inside;
    }
  } // namespace

  void
  turn_outward(TriangleMesh &mesh)
  {
    PartSearch search(mesh);
    std::vector<std::vector<std::size_t>> parts;
    std::vector<TriangleMesh> meshes;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      if (!search.has_reached(t))
        {
          parts.push_back(search.part_with(t));
          if (volume_moments(extracted(mesh, parts.back())).volume < 0.)
            for (const std::size_t triangle : parts.back())
              turn_over(mesh.triangles[triangle]);
          meshes.push_back(extracted(mesh, parts.back()));
        }

    for (std::size_t inner = 0; inner < parts.size(); ++inner)
      {
        int depth = 0;
        for (std::size_t outer = 0; outer < parts.size(); ++outer)
          if (outer != inner && encloses(meshes[outer], meshes[inner]))
            ++depth;
        if (depth % 2 == 1)
          for (const std::size_t triangle : parts[inner])
            turn_over(mesh.triangles[triangle]);
      }
  }
} // namespace magmpm
