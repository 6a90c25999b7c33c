#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/cylinder_shape.h>
#include <magmpm/geometry/mesh_file.h>
#include <magmpm/geometry/mesh_shape.h>
#include <magmpm/geometry/point_cloud_shape.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/motion/pose.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  std::vector<WayOut<dim>>
  ways_by_faces(const std::vector<Vector<dim>> &places,
                const std::vector<double> &depths,
                const double least_depth)
  {
    std::vector<WayOut<dim>> ways;
    double sum = 0.;
    for (std::size_t k = 0; k < places.size(); ++k)
      {
        const double depth = std::max(depths[k], least_depth);
        ways.push_back({places[k], 1. / (depth * depth)});
        sum += ways.back().weight;
      }
    for (WayOut<dim> &way : ways)
      way.weight /= sum;
    return ways;
  }

  template <int dim>
  std::vector<WayOut<dim>>
  Shape<dim>::ways_out(const Vector<dim> &point) const
  {
    const BoundingBox<dim> box         = bounding_box();
    const SurfaceDistance<dim> nearest = surface_distance(point);
    double beyond                      = 1e-9 * norm(box.upper - box.lower);
    Vector<dim> place                  = point + (beyond - nearest.distance) * nearest.normal;
    // The distance of a mesh is a sampled one.
    for (; contains(place) && beyond < norm(box.upper - box.lower); beyond *= 4.)
      place = point + (beyond - nearest.distance) * nearest.normal;
    return {{place, 1.}};
  }

  template <int dim>
  std::unique_ptr<Shape<dim>>
  make_shape(const ShapeParameters<dim> &parameters)
  {
    if (parameters.type == ShapeType::box)
      return std::make_unique<BoxShape<dim>>(parameters.lower_corner, parameters.upper_corner);
    if (parameters.type == ShapeType::sphere)
      return std::make_unique<SphereShape<dim>>(parameters.centre, parameters.radius);
    if constexpr (dim == 3)
      {
        if (parameters.type == ShapeType::cylinder)
          return std::make_unique<CylinderShape>(
            parameters.centre, parameters.axis, parameters.radius, parameters.length);
        if (parameters.type == ShapeType::mesh)
          {
            TriangleMesh mesh = read_closed_mesh(parameters.file);
            transform(parameters.scale,
                      rotation_by<dim>(parameters.rotation),
                      parameters.translation,
                      mesh);
            return std::make_unique<MeshShape>(mesh, parameters.sample_spacing);
          }
      }
    if (parameters.type == ShapeType::points)
      return std::make_unique<PointCloudShape<dim>>(read_point_cloud(parameters));
    throw InputError("A cylinder and a mesh need three dimensions.");
  }

  template std::unique_ptr<Shape<2>>
  make_shape(const ShapeParameters<2> &);
  template std::unique_ptr<Shape<3>>
  make_shape(const ShapeParameters<3> &);
  template std::vector<WayOut<2>>
  ways_by_faces(const std::vector<Vector<2>> &, const std::vector<double> &, double);
  template std::vector<WayOut<3>>
  ways_by_faces(const std::vector<Vector<3>> &, const std::vector<double> &, double);

  template class Shape<2>;
  template class Shape<3>;
} // namespace magmpm
