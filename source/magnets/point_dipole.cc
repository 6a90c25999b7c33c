#include <magmpm/base/constants.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/magnets/point_dipole.h>

namespace magmpm
{
  template <int dim>
  PointDipole<dim>::PointDipole(const double core_radius)
    : core(core_radius)
    , inverse_core_volume(
        1. / (constants::pi * core_radius * core_radius * (dim == 3 ? 4. / 3. * core_radius : 1.)))
  {
  }

  template <int dim>
  Vector<dim>
  PointDipole<dim>::field(const Vector<dim> &moment, const Vector<dim> &point) const
  {
    return core.field(inverse_core_volume * moment, point);
  }

  template <int dim>
  Matrix<dim>
  PointDipole<dim>::field_gradient(const Vector<dim> &moment, const Vector<dim> &point) const
  {
    return core.field_gradient(inverse_core_volume * moment, point);
  }

  template <int dim>
  Vector<dim>
  PointDipole<dim>::strength(const Vector<dim> &moment) const
  {
    return core.strength(inverse_core_volume * moment);
  }

  template <int dim>
  bool
  PointDipole<dim>::is_axisymmetric(const Vector<dim> & /*moment*/) const
  {
    return true;
  }

  template <int dim>
  double
  PointDipole<dim>::reach() const
  {
    return 0.;
  }

  template <int dim>
  std::optional<ForceAndTorque<dim>>
  PointDipole<dim>::force_and_torque(const Vector<dim> &moment,
                                     const ActingField<dim> &acting) const
  {
    return act_on<dim>({{{}, 1.}}, moment, acting);
  }

  template <int dim>
  SourceParts<dim>
  make_parts(const PointDipoleParameters<dim> &parameters, const std::string &name)
  {
    check_positive(parameters.radius, "radius of the core of the point dipole", name);
    SourceParts<dim> parts;
    parts.field     = std::make_unique<PointDipole<dim>>(parameters.radius);
    parts.amplitude = parameters.moment;
    parts.shape     = std::make_unique<SphereShape<dim>>(Vector<dim>(), parameters.radius);
    return parts;
  }

  template class PointDipole<2>;
  template class PointDipole<3>;
  template SourceParts<2>
  make_parts(const PointDipoleParameters<2> &, const std::string &);
  template SourceParts<3>
  make_parts(const PointDipoleParameters<3> &, const std::string &);
} // namespace magmpm
