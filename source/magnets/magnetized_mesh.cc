#include <magmpm/base/constants.h>
#include <magmpm/geometry/mesh_file.h>
#include <magmpm/geometry/mesh_shape.h>
#include <magmpm/magnets/magnetized_mesh.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace magmpm
{
  namespace
  {
    using constants::pi;

    /** Of the size of the mesh. */
    constexpr double surface_tolerance = 1e-9, least_edge_distance = 1e-5;
  } // namespace

  MagnetizedMesh::MagnetizedMesh(const TriangleMesh &mesh)
    : box(bounding_box(mesh))
    , moments(volume_moments(mesh))
    , points(mesh.points)
  {
    size = norm(box.upper - box.lower);
    for (const auto &corners : mesh.triangles)
      {
        const Vector<3> normal = cross(points[corners[1]] - points[corners[0]],
                                       points[corners[2]] - points[corners[0]]);
        const double length    = norm(normal);
        if (length > 1e-14 * size * size)
          triangles.push_back({corners, (1. / length) * normal, length});
      }
    make_sides();
  }

  void
  MagnetizedMesh::make_sides()
  {
    std::map<std::pair<int, int>, Side> all;
    for (const Triangle &triangle : triangles)
      for (int i = 0; i < 3; ++i)
        {
          const int start = triangle.corners[i], end = triangle.corners[(i + 1) % 3];
          const int from = std::min(start, end), to = std::max(start, end);
          const Vector<3> along = points[end] - points[start];
          Side &side            = all[{from, to}];
          side.from             = from;
          side.to               = to;
          side.length           = norm(along);
          side.across += outer((1. / side.length) * cross(along, triangle.normal), triangle.normal);
          side.triangles.push_back({triangle.normal, start == from ? 1. : -1.});
        }
    for (auto &entry : all)
      {
        // Between triangles of one plane nothing is left.
        Side &side = entry.second;
        Matrix<3> turns;
        for (const Side::Turn &turn : side.triangles)
          turns += turn.sign * outer(turn.normal, turn.normal);
        if (frobenius_norm(side.across) > 1e-10 || frobenius_norm(turns) > 1e-10)
          sides.push_back(side);
      }
  }

  std::vector<double>
  MagnetizedMesh::distances(const Vector<3> &point) const
  {
    std::vector<double> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      result[i] = norm(points[i] - point);
    return result;
  }

  double
  MagnetizedMesh::solid_angle(const Triangle &triangle,
                              const Vector<3> &point,
                              const std::vector<double> &distances) const
  {
    const auto &[i, j, k] = triangle.corners;
    const Vector<3> a = points[i] - point, b = points[j] - point, c = points[k] - point;
    const double A = distances[i], B = distances[j], C = distances[k];
    double height = -dot(triangle.normal, a);
    if (std::abs(height) < surface_tolerance * size)
      height = surface_tolerance * size;
    return 2. * std::atan2(triangle.twice_area * height,
                           A * B * C + dot(a, b) * C + dot(b, c) * A + dot(c, a) * B);
  }

  Vector<3>
  MagnetizedMesh::field(const Vector<3> &magnetization, const Vector<3> &point) const
  {
    const std::vector<double> distances = this->distances(point);
    Vector<3> sum;
    for (const Triangle &triangle : triangles)
      {
        const double charge = dot(triangle.normal, magnetization);
        if (charge != 0.)
          sum += (charge * solid_angle(triangle, point, distances)) * triangle.normal;
      }
    for (const Side &side : sides)
      {
        const double l    = side.length;
        const double path = distances[side.from] + distances[side.to];
        // On the side itself the path is no longer than l; at the distance d in its middle 2 d^2/l more.
        const double excess =
          std::max(path - l, 2. * least_edge_distance * least_edge_distance * size * size / l);
        sum += std::log((excess + 2. * l) / excess) * (side.across * magnetization);
      }
    return (1. / (4. * pi)) * sum;
  }

  Matrix<3>
  MagnetizedMesh::field_gradient(const Vector<3> &magnetization, const Vector<3> &point) const
  {
    const double least = least_edge_distance * size;
    Matrix<3> sum;
    for (const Side &side : sides)
      {
        const Vector<3> a = point - points[side.from], b = point - points[side.to];
        const double A = std::max(norm(a), least), B = std::max(norm(b), least);
        const double path     = A + B;
        const double squares  = std::max(path * path - side.length * side.length,
                                        4. * least * least);
        const Vector<3> slope = (-2. * side.length / squares) * ((1. / A) * a + (1. / B) * b);
        sum += outer(side.across * magnetization, slope);

        // The gradient of a solid angle is a sum over the sides as well (Biot and Savart).
        Vector<3> turned;
        for (const Side::Turn &turn : side.triangles)
          turned += (turn.sign * dot(turn.normal, magnetization)) * turn.normal;
        sum += outer(turned, (2. * path / (A * B * squares)) * cross(b, a));
      }
    return (1. / (4. * pi)) * sum;
  }

  bool
  MagnetizedMesh::is_inside(const Vector<3> &point) const
  {
    for (int d = 0; d < 3; ++d)
      if (point[d] <= box.lower[d] || point[d] >= box.upper[d])
        return false;
    const std::vector<double> distances = this->distances(point);
    double angle                        = 0.; // -4 pi inside, 0 outside
    for (const Triangle &triangle : triangles)
      angle += solid_angle(triangle, point, distances);
    return angle < -2. * pi;
  }

  Vector<3>
  MagnetizedMesh::strength(const Vector<3> &magnetization) const
  {
    return magnetization;
  }

  bool
  MagnetizedMesh::is_axisymmetric(const Vector<3> & /*magnetization*/) const
  {
    return false;
  }

  double
  MagnetizedMesh::reach() const
  {
    double reach = 0.;
    for (const Vector<3> &point : points)
      reach = std::max(reach, norm(point));
    return reach;
  }

  std::vector<VolumeElement<3>>
  MagnetizedMesh::make_elements() const
  {
    constexpr int n_along = 12;
    const Vector<3> edges = box.upper - box.lower;
    const double spacing  = *std::max_element(edges.values, edges.values + 3) / n_along;
    int n[3];
    for (int d = 0; d < 3; ++d)
      n[d] = std::max(1, static_cast<int>(std::round(edges[d] / spacing)));
    std::vector<Vector<3>> middles;
    Vector<3> mean;
    for (int i = 0; i < n[0]; ++i)
      for (int j = 0; j < n[1]; ++j)
        for (int k = 0; k < n[2]; ++k)
          {
            const Vector<3> middle = {{box.lower[0] + (i + 0.5) * edges[0] / n[0],
                                       box.lower[1] + (j + 0.5) * edges[1] / n[1],
                                       box.lower[2] + (k + 0.5) * edges[2] / n[2]}};
            if (!is_inside(middle))
              continue;
            middles.push_back(middle);
            mean += middle;
          }
    if (middles.empty())
      middles.push_back(mean);
    // Moved to the right centroid, so that in a uniform gradient the torque is exact as well.
    const Vector<3> shift = moments.centroid - (1. / middles.size()) * mean;
    std::vector<VolumeElement<3>> result;
    for (const Vector<3> &middle : middles)
      result.push_back({middle + shift, moments.volume / middles.size()});
    return result;
  }

  std::optional<ForceAndTorque<3>>
  MagnetizedMesh::force_and_torque(const Vector<3> &magnetization,
                                   const ActingField<3> &acting) const
  {
    if (elements.empty())
      elements = make_elements();
    return act_on(elements, magnetization, acting);
  }

  SourceParts<3>
  make_parts(const MagnetizedMeshParameters &parameters, const std::string & /*name*/)
  {
    TriangleMesh mesh = read_closed_mesh(parameters.file);
    transform(parameters.scale, identity<3>(), {}, mesh);
    SourceParts<3> parts;
    parts.field     = std::make_unique<MagnetizedMesh>(mesh);
    parts.amplitude = parameters.magnetization;
    parts.shape     = std::make_unique<MeshShape>(mesh);
    return parts;
  }
} // namespace magmpm
