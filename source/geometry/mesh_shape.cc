#include <magmpm/geometry/distance_samples.h>
#include <magmpm/geometry/mesh_shape.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    double
    derived_spacing(const BoundingBox<3> &box)
    {
      constexpr double max_samples = 3e5;
      const Vector<3> edge         = box.upper - box.lower;
      const double of_longest      = std::max({edge[0], edge[1], edge[2]}) / 64.;
      const double of_all          = std::cbrt(edge[0] * edge[1] * edge[2] / max_samples);
      return std::max(of_longest, of_all);
    }
  } // namespace

  MeshShape::MeshShape(const TriangleMesh &mesh, const double sample_spacing)
    : triangles(mesh)
    , box(magmpm::bounding_box(mesh))
    , sample_spacing(sample_spacing > 0. ? sample_spacing : derived_spacing(box))
    , interior(triangles)
  {
  }

  MeshShape::~MeshShape() = default;

  bool
  MeshShape::contains(const Vector<3> &point) const
  {
    return interior.contains(point);
  }

  SurfaceDistance<3>
  MeshShape::surface_distance(const Vector<3> &point) const
  {
    if (samples == nullptr)
      samples = std::make_unique<DistanceSamples>(triangles, interior, sample_spacing);
    return samples->at(point);
  }

  BoundingBox<3>
  MeshShape::bounding_box() const
  {
    return box;
  }

  VolumeMoments<3>
  MeshShape::volume_moments() const
  {
    return magmpm::volume_moments(triangles);
  }

  RegionMoments<3>
  MeshShape::moments_within(const BoundingBox<3> &cell, const int /*depth*/) const
  {
    return interior.moments_within(cell);
  }

  std::vector<Vector<3>>
  MeshShape::surface_points(const double spacing) const
  {
    return magmpm::surface_points(triangles, spacing);
  }

  SurfaceMesh<3>
  MeshShape::surface_mesh(const double /*spacing*/) const
  {
    return {triangles.points, triangles.triangles};
  }
} // namespace magmpm
