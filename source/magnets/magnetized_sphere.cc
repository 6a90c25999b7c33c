#include <magmpm/base/constants.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/magnets/magnetized_sphere.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** x^dim; std::pow() would take as long as all the rest of a field. */
    template <int dim>
    double
    power(const double x)
    {
      return dim == 3 ? x * x * x : x * x;
    }
  } // namespace

  template <int dim>
  MagnetizedSphere<dim>::MagnetizedSphere(const double radius)
    : radius(radius)
  {
  }

  template <int dim>
  Vector<dim>
  MagnetizedSphere<dim>::field(const Vector<dim> &magnetization, const Vector<dim> &point) const
  {
    const Vector<dim> &m  = magnetization;
    const double distance = norm(point);
    if (distance < radius)
      return (-1. / dim) * m;

    const Vector<dim> n = (1. / distance) * point;
    const double decay  = power<dim>(radius / distance);
    return (decay / dim) * ((dim * dot(m, n)) * n - m);
  }

  template <int dim>
  Matrix<dim>
  MagnetizedSphere<dim>::field_gradient(const Vector<dim> &magnetization,
                                        const Vector<dim> &point) const
  {
    const Vector<dim> &m  = magnetization;
    const double distance = norm(point);
    if (distance < radius)
      return {};

    const Vector<dim> n = (1. / distance) * point;
    const double decay  = power<dim>(radius / distance);
    return (decay / distance) * (outer(m, n) + outer(n, m) +
                                 dot(m, n) * (identity<dim>() + (-(dim + 2.)) * outer(n, n)));
  }

  template <int dim>
  bool
  MagnetizedSphere<dim>::is_inside(const Vector<dim> &point) const
  {
    return norm(point) < radius;
  }

  template <int dim>
  Vector<dim>
  MagnetizedSphere<dim>::strength(const Vector<dim> &magnetization) const
  {
    return ((dim - 1.) / dim) * magnetization;
  }

  template <int dim>
  bool
  MagnetizedSphere<dim>::is_axisymmetric(const Vector<dim> & /*magnetization*/) const
  {
    return true;
  }

  template <int dim>
  double
  MagnetizedSphere<dim>::reach() const
  {
    return 0.;
  }

  template <int dim>
  std::optional<ForceAndTorque<dim>>
  MagnetizedSphere<dim>::force_and_torque(const Vector<dim> &magnetization,
                                          const ActingField<dim> &acting) const
  {
    const double unit_ball = dim == 3 ? 4. / 3. * constants::pi : constants::pi;
    return act_on<dim>({{{}, unit_ball * power<dim>(radius)}}, magnetization, acting);
  }

  template <int dim>
  SourceParts<dim>
  make_parts(const MagnetizedSphereParameters<dim> &parameters, const std::string &name)
  {
    check_positive(parameters.radius, "radius of the magnetized sphere", name);
    SourceParts<dim> parts;
    parts.field     = std::make_unique<MagnetizedSphere<dim>>(parameters.radius);
    parts.amplitude = parameters.magnetization;
    parts.shape     = std::make_unique<SphereShape<dim>>(Vector<dim>(), parameters.radius);
    return parts;
  }

  template class MagnetizedSphere<2>;
  template class MagnetizedSphere<3>;
  template SourceParts<2>
  make_parts(const MagnetizedSphereParameters<2> &, const std::string &);
  template SourceParts<3>
  make_parts(const MagnetizedSphereParameters<3> &, const std::string &);
} // namespace magmpm
