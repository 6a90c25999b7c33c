#include <magmpm/base/constants.h>
#include <magmpm/geometry/cylinder_shape.h>
#include <magmpm/magnets/axial_field.h>
#include <magmpm/magnets/cylinder.h>
#include <magmpm/magnets/gauss_points.h>
#include <magmpm/magnets/ring_integrals.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    using constants::pi;

    /** Second derivatives of Phi in cylindrical coordinates; (rho, phi) and (z, phi) are zero. */
    struct Hessian
    {
      double zz, z_rho, rho_rho, phi_phi;
      double z_rho_over_rho;
    };
  } // namespace

  struct Cylinder::Place
  {
    double rho;
    double height[2]; ///< above the lower and the upper end
    bool inside;
    Vector<3> outward;

    Hessian
    hessian(const double radius, const double least_distance) const
    {
      Hessian h = {0., 0., 0., 0., 0.};
      for (int end = 0; end < 2; ++end)
        {
          const double z           = height[end];
          const double factor      = (end == 0 ? 1. : -1.) / (4. * pi);
          const RingIntegrals ring = ring_integrals(radius, rho, z, least_distance);
          const RimIntegrals rim   = rim_integrals(radius, rho, z, least_distance);
          const double whole       = (rho < radius ? 2. * pi : rho > radius ? 0. : pi);
          const double solid_angle = (z < 0. ? -whole : whole) - z * rim.angle;
          h.zz -= factor * solid_angle;
          h.z_rho_over_rho -= factor * radius * ring.potential;
          h.phi_phi -= factor * radius * radius * z * rim.across;
        }
      h.z_rho   = rho * h.z_rho_over_rho;
      h.rho_rho = -(inside ? 1. : 0.) - h.zz - h.phi_phi;
      return h;
    }
  };

  Cylinder::Cylinder(const double radius, const double length)
    : radius(radius)
    , half_length(0.5 * length)
    , surface_tolerance(1e-9 * std::max(radius, length))
    , least_edge_distance(1e-4 * std::min(radius, length))
  {
    constexpr int n_angles = 10;
    for (const GaussPoint &z : gauss_points())
      for (const GaussPoint &rho2 : gauss_points())
        for (int i = 0; i < n_angles; ++i)
          {
            const double angle = 2. * pi * i / n_angles, rho = radius * std::sqrt(rho2.position);
            elements.push_back(
              {{{rho * std::cos(angle), rho * std::sin(angle), (z.position - 0.5) * length}},
               z.weight * rho2.weight * pi * radius * radius * length / n_angles});
          }
  }

  Cylinder::Place
  Cylinder::place(const Vector<3> &point) const
  {
    const AxialPlace axial(point);
    Place place = {
      axial.rho, {point[2] + half_length, point[2] - half_length}, false, axial.outward};
    if (std::abs(place.rho - radius) < surface_tolerance)
      place.rho = radius + surface_tolerance;
    if (std::abs(place.height[0]) < surface_tolerance)
      place.height[0] = -surface_tolerance;
    if (std::abs(place.height[1]) < surface_tolerance)
      place.height[1] = surface_tolerance;
    place.inside = place.rho < radius && place.height[0] > 0. && place.height[1] < 0.;
    return place;
  }

  Vector<3>
  Cylinder::field(const Vector<3> &magnetization, const Vector<3> &point) const
  {
    const Place here        = place(point);
    const Hessian h         = here.hessian(radius, least_edge_distance);
    const Vector<3> &m      = magnetization;
    const double m_outward  = dot(m, here.outward);
    const Vector<3> m_round = Vector<3>{{m[0], m[1], 0.}} - m_outward * here.outward;
    Vector<3> result        = h.phi_phi * m_round +
                       (h.rho_rho * m_outward + h.z_rho * m[2]) * here.outward;
    result[2] = h.z_rho * m_outward + h.zz * m[2];
    return result;
  }

  Matrix<3>
  Cylinder::field_gradient(const Vector<3> &magnetization, const Vector<3> &point) const
  {
    const Place here = place(point);
    const double rho = here.rho;
    const Hessian h  = here.hessian(radius, least_edge_distance);
    // Third derivatives; those with an odd number of phi vanish, traces do too.
    double zzz = 0., zz_rho = 0.;
    for (int end = 0; end < 2; ++end)
      {
        const double z           = here.height[end];
        const double factor      = (end == 0 ? 1. : -1.) / (4. * pi);
        const RingIntegrals ring = ring_integrals(radius, rho, z, least_edge_distance);
        zzz += factor * ring.axial;
        zz_rho += factor * z * rho * ring.radial;
      }
    const double z_phi_phi   = h.z_rho_over_rho;
    const double z_rho_rho   = -zzz - z_phi_phi;
    const double rho_phi_phi = rho > 1e-7 * radius ? (h.rho_rho - h.phi_phi) / rho : 0.;
    const double rho_rho_rho = -zz_rho - rho_phi_phi;

    const Vector<3> &e = here.outward, round = {{-e[1], e[0], 0.}}, z = {{0., 0., 1.}};
    const double m_e = dot(magnetization, e), m_round = dot(magnetization, round);
    const double m_z     = magnetization[2];
    const double e_round = rho_phi_phi * m_round, z_round = z_phi_phi * m_round;
    const double e_z = z_rho_rho * m_e + zz_rho * m_z;
    return (rho_rho_rho * m_e + z_rho_rho * m_z) * outer(e, e) +
           (rho_phi_phi * m_e + z_phi_phi * m_z) * outer(round, round) +
           (zz_rho * m_e + zzz * m_z) * outer(z, z) +
           e_round * (outer(e, round) + outer(round, e)) +
           z_round * (outer(z, round) + outer(round, z)) + e_z * (outer(e, z) + outer(z, e));
  }

  bool
  Cylinder::is_inside(const Vector<3> &point) const
  {
    return place(point).inside;
  }

  Vector<3>
  Cylinder::strength(const Vector<3> &magnetization) const
  {
    return magnetization;
  }

  bool
  Cylinder::is_axisymmetric(const Vector<3> &magnetization) const
  {
    return std::hypot(magnetization[0], magnetization[1]) <= 1e-14 * std::abs(magnetization[2]);
  }

  double
  Cylinder::reach() const
  {
    return std::hypot(radius, half_length);
  }

  std::optional<ForceAndTorque<3>>
  Cylinder::force_and_torque(const Vector<3> &magnetization, const ActingField<3> &acting) const
  {
    return act_on(elements, magnetization, acting);
  }

  SourceParts<3>
  make_parts(const CylinderParameters &parameters, const std::string &name)
  {
    check_positive(parameters.radius, "radius of the cylinder", name);
    check_positive(parameters.length, "length of the cylinder", name);
    const Vector<3> z = {{0., 0., 1.}};
    SourceParts<3> parts;
    parts.field     = std::make_unique<Cylinder>(parameters.radius, parameters.length);
    parts.amplitude = parameters.magnetization;
    parts.axis      = parameters.axis;
    parts.shape     = std::make_unique<CylinderShape>(Vector<3>(),
                                                  norm(parameters.axis) > 0. ? parameters.axis : z,
                                                  parameters.radius,
                                                  parameters.length);
    return parts;
  }
} // namespace magmpm
