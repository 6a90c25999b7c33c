#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/cylinder_shape.h>
#include <magmpm/geometry/mesh_file.h>
#include <magmpm/geometry/mesh_shape.h>
#include <magmpm/geometry/point_cloud_shape.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/motion/pose.h>

namespace magmpm
{
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
} // namespace magmpm
