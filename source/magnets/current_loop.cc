#include <magmpm/base/constants.h>
#include <magmpm/magnets/axial_field.h>
#include <magmpm/magnets/current_loop.h>
#include <magmpm/magnets/ring_integrals.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    using constants::pi;

    /** A place in the half plane through the axis, and how far inside of the conductor it was. */
    struct Section
    {
      double rho, z;
      double depth = 1.; ///< distance from the middle of the conductor over its radius, inside
      double across[2];  ///< direction from that middle: along rho and z

      Section(const double rho, const double z, const double radius, const double conductor_radius)
        : rho(rho)
        , z(z)
        , across{1., 0.}
      {
        const double distance = std::hypot(rho - radius, z);
        if (distance >= conductor_radius)
          return;
        depth = distance / conductor_radius;
        if (distance > 0.)
          {
            across[0] = (rho - radius) / distance;
            across[1] = z / distance;
          }
        this->rho = radius + conductor_radius * across[0];
        this->z   = conductor_radius * across[1];
      }
    };
  } // namespace

  CurrentLoop::CurrentLoop(const double radius, const double conductor_radius)
    : radius(radius)
    , conductor_radius(conductor_radius)
  {
    constexpr int n_pieces = 64;
    for (int i = 0; i < n_pieces; ++i)
      {
        const double angle = 2. * pi * i / n_pieces, length = 2. * pi * radius / n_pieces;
        elements.push_back({{{radius * std::cos(angle), radius * std::sin(angle), 0.}},
                            {{-length * std::sin(angle), length * std::cos(angle), 0.}}});
      }
  }

  Vector<3>
  CurrentLoop::field(const Vector<3> &current, const Vector<3> &point) const
  {
    const AxialPlace place(point);
    const Section at(place.rho, point[2], radius, conductor_radius);
    const RingIntegrals ring = ring_integrals(radius, at.rho, at.z, conductor_radius);
    const double factor      = at.depth * current[0] / (4. * pi);
    Vector<3> result         = (factor * at.rho * at.z * ring.radial) * place.outward;
    result[2]                = factor * ring.axial;
    return result;
  }

  Matrix<3>
  CurrentLoop::field_gradient(const Vector<3> &current, const Vector<3> &point) const
  {
    const AxialPlace place(point);
    const Section at(place.rho, point[2], radius, conductor_radius);
    const RingIntegrals ring         = ring_integrals(radius, at.rho, at.z, conductor_radius);
    const RingDerivatives derivative = ring_derivatives(radius, at.rho, at.z, conductor_radius);
    const double H[2]                = {at.rho * at.z * ring.radial, ring.axial}; // along rho and z
    double over_rho                  = at.z * ring.radial;                        // H_rho/rho
    // Derivatives by rho and z: no curl, no divergence.
    double slope[2][2] = {{-derivative.axial - over_rho, derivative.radial},
                          {derivative.radial, derivative.axial}};
    if (at.depth < 1.)
      {
        // H = depth H(surface point), which moves only as the point goes round the conductor's middle.
        const double round[2] = {-at.across[1], at.across[0]};
        for (int i = 0; i < 2; ++i)
          {
            const double along_surface = slope[i][0] * round[0] + slope[i][1] * round[1];
            for (int j = 0; j < 2; ++j)
              slope[i][j] = H[i] * at.across[j] / conductor_radius + along_surface * round[j];
          }
        over_rho = at.depth * H[0] / place.rho;
      }
    const Vector<3> &e = place.outward, round = {{-e[1], e[0], 0.}}, z = {{0., 0., 1.}};
    return (current[0] / (4. * pi)) *
           (slope[0][0] * outer(e, e) + slope[0][1] * outer(e, z) + slope[1][0] * outer(z, e) +
            slope[1][1] * outer(z, z) + over_rho * outer(round, round));
  }

  Vector<3>
  CurrentLoop::strength(const Vector<3> &current) const
  {
    return {{0., 0., current[0] / (2. * pi * conductor_radius)}};
  }

  bool
  CurrentLoop::is_axisymmetric(const Vector<3> & /*current*/) const
  {
    return true;
  }

  double
  CurrentLoop::reach() const
  {
    return radius;
  }

  std::optional<ForceAndTorque<3>>
  CurrentLoop::force_and_torque(const Vector<3> &current, const ActingField<3> &acting) const
  {
    return act_on(elements, current[0], acting);
  }

  SourceParts<3>
  make_parts(const CurrentLoopParameters &parameters, const std::string &name)
  {
    check_positive(parameters.radius, "radius of the current loop", name);
    check_positive(parameters.conductor_radius, "conductor radius of the current loop", name);
    SourceParts<3> parts;
    parts.field     = std::make_unique<CurrentLoop>(parameters.radius, parameters.conductor_radius);
    parts.amplitude = current_amplitude<3>(parameters.current);
    parts.axis      = parameters.axis;
    parts.is_current = true;
    return parts;
  }
} // namespace magmpm
