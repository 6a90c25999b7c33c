#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/magnetized_sphere.h>

#include <cmath>
#include <sstream>

namespace magmpm
{
  template <int dim>
  MagnetizedSphere<dim>::MagnetizedSphere(const SourceParameters<dim> &parameters)
    : MagneticSource<dim>(parameters.name)
    , position_script(parameters.position, "Position of source '" + parameters.name + "'")
    , magnetization_script(parameters.magnetization,
                           "Magnetization of source '" + parameters.name + "'")
    , sphere_radius(parameters.radius)
    , contact_condition(parameters.contact)
  {
    if (!(sphere_radius > 0. && std::isfinite(sphere_radius)))
      {
        std::ostringstream message;
        message << "The radius of the magnetized sphere '" << parameters.name << "' is "
                << sphere_radius << " m. Give a positive one.";
        throw InputError(message.str());
      }
    set_time(0.);
  }

  template <int dim>
  void
  MagnetizedSphere<dim>::set_time(const double time)
  {
    current_centre        = position_script.value(time);
    current_velocity      = position_script.velocity(time);
    current_magnetization = magnetization_script.value(time);
  }

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
  Vector<dim>
  MagnetizedSphere<dim>::field(const Vector<dim> &point) const
  {
    const Vector<dim> &m  = current_magnetization;
    const Vector<dim> r   = point - current_centre;
    const double distance = norm(r);
    if (distance < sphere_radius)
      return (-1. / dim) * m;

    const Vector<dim> n = (1. / distance) * r;
    const double decay  = power<dim>(sphere_radius / distance);
    return (decay / dim) * ((dim * dot(m, n)) * n - m);
  }

  template <int dim>
  Matrix<dim>
  MagnetizedSphere<dim>::field_gradient(const Vector<dim> &point) const
  {
    const Vector<dim> &m  = current_magnetization;
    const Vector<dim> r   = point - current_centre;
    const double distance = norm(r);
    if (distance < sphere_radius)
      return {};

    const Vector<dim> n = (1. / distance) * r;
    const double decay  = power<dim>(sphere_radius / distance);
    return (decay / distance) * (outer(m, n) + outer(n, m) +
                                 dot(m, n) * (identity<dim>() + (-(dim + 2.)) * outer(n, n)));
  }

  template <int dim>
  bool
  MagnetizedSphere<dim>::is_constant() const
  {
    // A sphere without magnetization (a mere obstacle) may go where it wants.
    return magnetization_script.is_constant() &&
           (position_script.is_constant() || norm(current_magnetization) == 0.);
  }

  template <int dim>
  Vector<dim>
  MagnetizedSphere<dim>::strength() const
  {
    return ((dim - 1.) / dim) * current_magnetization;
  }

  template <int dim>
  Vector<dim>
  MagnetizedSphere<dim>::centre() const
  {
    return current_centre;
  }

  template <int dim>
  Vector<dim>
  MagnetizedSphere<dim>::moment() const
  {
    const double unit_ball = dim == 3 ? 4. / 3. * constants::pi : constants::pi;
    return (unit_ball * std::pow(sphere_radius, dim)) * current_magnetization;
  }

  template class MagnetizedSphere<2>;
  template class MagnetizedSphere<3>;
} // namespace magmpm
