#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/cylinder_shape.h>
#include <magmpm/geometry/mesh_file.h>
#include <magmpm/geometry/mesh_shape.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/magnets/cuboid.h>
#include <magmpm/magnets/current_loop.h>
#include <magmpm/magnets/cylinder.h>
#include <magmpm/magnets/magnetized_mesh.h>
#include <magmpm/magnets/magnetized_sphere.h>
#include <magmpm/magnets/make_source.h>
#include <magmpm/magnets/placed_source.h>
#include <magmpm/magnets/point_dipole.h>
#include <magmpm/magnets/straight_wire.h>
#include <magmpm/magnets/uniform_field.h>

#include <cmath>
#include <sstream>

namespace magmpm
{
  namespace
  {
    void
    check_positive(const double length, const std::string &what, const std::string &source)
    {
      if (length > 0. && std::isfinite(length))
        return;
      std::ostringstream message;
      message << "The " << what << " '" << source << "' is " << length
              << " m. Give a positive one.";
      throw InputError(message.str());
    }
  } // namespace

  namespace
  {
    /** A field and the space that its source fills. */
    template <int dim>
    struct FieldAndShape
    {
      std::unique_ptr<SourceField<dim>> field;
      std::unique_ptr<Shape<dim>> shape;
    };

    /** Of the sources that are in 3D only. */
    FieldAndShape<3>
    make_spatial(const SourceParameters<3> &p)
    {
      if (p.type == SourceType::cylinder)
        {
          check_positive(p.radius, "radius of the cylinder", p.name);
          check_positive(p.length, "length of the cylinder", p.name);
          const Vector<3> z = {{0., 0., 1.}};
          return {std::make_unique<Cylinder>(p.radius, p.length),
                  std::make_unique<CylinderShape>(
                    Vector<3>(), norm(p.axis) > 0. ? p.axis : z, p.radius, p.length)};
        }
      if (p.type == SourceType::current_loop)
        {
          check_positive(p.radius, "radius of the current loop", p.name);
          check_positive(p.conductor_radius, "conductor radius of the current loop", p.name);
          return {std::make_unique<CurrentLoop>(p.radius, p.conductor_radius), nullptr};
        }
      TriangleMesh mesh = read_closed_mesh(p.file);
      transform(p.scale, identity<3>(), {}, mesh);
      return {std::make_unique<MagnetizedMesh>(mesh), std::make_unique<MeshShape>(mesh)};
    }

    template <int dim>
    FieldAndShape<dim>
    make_field(const SourceParameters<dim> &p)
    {
      switch (p.type)
        {
          case SourceType::point_dipole:
            check_positive(p.radius, "radius of the core of the point dipole", p.name);
            return {std::make_unique<PointDipole<dim>>(p.radius),
                    std::make_unique<SphereShape<dim>>(Vector<dim>(), p.radius)};
          case SourceType::magnetized_sphere:
            check_positive(p.radius, "radius of the magnetized sphere", p.name);
            return {std::make_unique<MagnetizedSphere<dim>>(p.radius),
                    std::make_unique<SphereShape<dim>>(Vector<dim>(), p.radius)};
          case SourceType::cuboid:
            for (int d = 0; d < dim; ++d)
              check_positive(p.size[d], "size of the cuboid", p.name);
            return {std::make_unique<Cuboid<dim>>(p.size),
                    std::make_unique<BoxShape<dim>>(-0.5 * p.size, 0.5 * p.size)};
          case SourceType::straight_wire:
            check_positive(p.conductor_radius, "conductor radius of the straight wire", p.name);
            return {std::make_unique<StraightWire<dim>>(p.conductor_radius, p.length), nullptr};
          default:
            if constexpr (dim == 3)
              return make_spatial(p);
            throw InputError("Source '" + p.name + "' is of a kind that needs three dimensions.");
        }
    }
  } // namespace

  template <int dim>
  std::unique_ptr<MagneticSource<dim>>
  make_source(const SourceParameters<dim> &parameters)
  {
    if (parameters.type == SourceType::uniform_field)
      return std::make_unique<UniformField<dim>>(parameters);
    FieldAndShape<dim> kind = make_field(parameters);
    if (parameters.contact != ContactCondition::none &&
        (kind.shape == nullptr || parameters.type == SourceType::point_dipole))
      throw InputError("Source '" + parameters.name +
                       "' has no surface, but has a contact condition. Set it to none.");
    return std::make_unique<PlacedSource<dim>>(
      parameters, std::move(kind.field), std::move(kind.shape));
  }

  template std::unique_ptr<MagneticSource<2>>
  make_source(const SourceParameters<2> &);
  template std::unique_ptr<MagneticSource<3>>
  make_source(const SourceParameters<3> &);
} // namespace magmpm
