#include <magmpm/base/exceptions.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/magnets/magnetized_sphere.h>
#include <magmpm/magnets/make_source.h>
#include <magmpm/magnets/placed_source.h>
#include <magmpm/magnets/point_dipole.h>
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

  template <int dim>
  std::unique_ptr<MagneticSource<dim>>
  make_source(const SourceParameters<dim> &parameters)
  {
    const std::string &name = parameters.name;
    const auto place        = [&](std::unique_ptr<SourceField<dim>> field,
                           std::unique_ptr<Shape<dim>> shape) {
      return std::make_unique<PlacedSource<dim>>(parameters, std::move(field), std::move(shape));
    };
    switch (parameters.type)
      {
        case SourceType::uniform_field:
          return std::make_unique<UniformField<dim>>(parameters);
        case SourceType::point_dipole:
          check_positive(parameters.radius, "radius of the core of the point dipole", name);
          return place(std::make_unique<PointDipole<dim>>(parameters.radius),
                       std::make_unique<SphereShape<dim>>(Vector<dim>(), parameters.radius));
        case SourceType::magnetized_sphere:
          check_positive(parameters.radius, "radius of the magnetized sphere", name);
          return place(std::make_unique<MagnetizedSphere<dim>>(parameters.radius),
                       std::make_unique<SphereShape<dim>>(Vector<dim>(), parameters.radius));
        default:
          throw InputError("There is no such source as '" + name + "' in " + std::to_string(dim) +
                           "D.");
      }
  }

  template std::unique_ptr<MagneticSource<2>>
  make_source(const SourceParameters<2> &);
  template std::unique_ptr<MagneticSource<3>>
  make_source(const SourceParameters<3> &);
} // namespace magmpm
