#include <magmpm/base/constants.h>
#include <magmpm/magnets/straight_wire.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    using constants::pi;

    /** e_z x r. */
    template <int dim>
    Vector<dim>
    round(const Vector<dim> &point)
    {
      Vector<dim> result;
      result[0] = -point[1];
      result[1] = point[0];
      return result;
    }
  } // namespace

  template <int dim>
  StraightWire<dim>::StraightWire(const double conductor_radius, const double length)
    : conductor_radius(conductor_radius)
    , half_length(0.5 * length)
  {
    constexpr int n_pieces = 64;
    for (int i = 0; i < n_pieces && length > 0.; ++i)
      elements.push_back(
        {{{0., 0., length * ((i + 0.5) / n_pieces - 0.5)}}, {{0., 0., length / n_pieces}}});
  }

  template <int dim>
  typename StraightWire<dim>::Factor
  StraightWire<dim>::factor(const Vector<dim> &point) const
  {
    const double rho2     = point[0] * point[0] + point[1] * point[1];
    const double a2       = conductor_radius * conductor_radius;
    const bool is_outside = rho2 >= a2;
    const double q        = is_outside ? rho2 : a2;
    if constexpr (dim == 3)
      if (half_length > 0.)
        {
          // The field is odd in neither z nor L: by symmetry z >= 0 is enough.
          const double z = std::abs(point[2]), z0 = z + half_length, z1 = z - half_length;
          const double R0 = std::sqrt(q + z0 * z0), R1 = std::sqrt(q + z1 * z1);
          // Beyond the end, without the difference of two numbers near 1.
          const double f      = z1 > 0. ? 1. / (R1 * (R1 + z1)) - 1. / (R0 * (R0 + z0))
                                        : (z0 / R0 - z1 / R1) / q;
          const double cubes0 = 1. / (R0 * R0 * R0), cubes1 = 1. / (R1 * R1 * R1);
          const double slope_z = cubes0 - cubes1;
          return {f / (4. * pi),
                  is_outside ? (z1 * cubes1 - z0 * cubes0 - 2. * f) / (4. * pi * q) : 0.,
                  (point[2] < 0. ? -slope_z : slope_z) / (4. * pi)};
        }
    return {1. / (2. * pi * q), is_outside ? -1. / (pi * q * q) : 0., 0.};
  }

  template <int dim>
  Vector<dim>
  StraightWire<dim>::field(const Vector<dim> &current, const Vector<dim> &point) const
  {
    return (current[0] * factor(point).f) * round(point);
  }

  template <int dim>
  Matrix<dim>
  StraightWire<dim>::field_gradient(const Vector<dim> &current, const Vector<dim> &point) const
  {
    const Factor factor = this->factor(point);
    Vector<dim> slope;
    slope[0] = factor.slope_rho * point[0];
    slope[1] = factor.slope_rho * point[1];
    if constexpr (dim == 3)
      slope[2] = factor.slope_z;
    Matrix<dim> gradient = outer(round(point), slope);
    gradient(0, 1) -= factor.f;
    gradient(1, 0) += factor.f;
    return current[0] * gradient;
  }

  template <int dim>
  Vector<dim>
  StraightWire<dim>::strength(const Vector<dim> &current) const
  {
    Vector<dim> result;
    result[dim == 3 ? 2 : 0] = current[0] / (2. * pi * conductor_radius);
    return result;
  }

  template <int dim>
  bool
  StraightWire<dim>::is_axisymmetric(const Vector<dim> & /*current*/) const
  {
    return true;
  }

  template <int dim>
  double
  StraightWire<dim>::reach() const
  {
    return half_length;
  }

  template <int dim>
  std::optional<ForceAndTorque<dim>>
  StraightWire<dim>::force_and_torque(const Vector<dim> &current,
                                      const ActingField<dim> &acting) const
  {
    if constexpr (dim == 2)
      return ForceAndTorque<2>{
        (constants::vacuum_permeability * current[0]) * round(acting({}).field), {}};
    else if (elements.empty())
      return {};
    else
      return act_on(elements, current[0], acting);
  }

  template <int dim>
  SourceParts<dim>
  make_parts(const StraightWireParameters<dim> &parameters, const std::string &name)
  {
    check_positive(parameters.conductor_radius, "conductor radius of the straight wire", name);
    SourceParts<dim> parts;
    parts.field      = std::make_unique<StraightWire<dim>>(parameters.conductor_radius,
                                                      parameters.length);
    parts.amplitude  = current_amplitude<dim>(parameters.current);
    parts.axis       = parameters.axis;
    parts.is_current = true;
    return parts;
  }

  template class StraightWire<2>;
  template class StraightWire<3>;
  template SourceParts<2>
  make_parts(const StraightWireParameters<2> &, const std::string &);
  template SourceParts<3>
  make_parts(const StraightWireParameters<3> &, const std::string &);
} // namespace magmpm
