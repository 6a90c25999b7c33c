#include "catch.h"

#include <magmpm/base/constants.h>

#include <verification/capillarity/drop_modes.h>
#include <verification/capillarity/gauss_rule.h>

#include <cmath>
#include <complex>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double pi = constants::pi;

  /** Surface over that of a sphere (2D: circumference over that of a circle) of the same volume, radius 1 + eps Y_n. */
  double
  relative_surface(const int dim, const int n, const double eps)
  {
    const GaussRule rule = gauss_rule(60);
    double surface = 0., volume = 0.;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
      {
        if (dim == 2)
          {
            const double angle = 2. * pi * rule.points[i], r = 1. + eps * std::cos(n * angle);
            surface += rule.weights[i] * std::hypot(r, eps * n * std::sin(n * angle));
            volume += rule.weights[i] * r * r;
            continue;
          }
        const double x = 2. * rule.points[i] - 1.;
        const double r = 1. + eps * legendre(n, x).value;
        surface += rule.weights[i] * r *
                   std::hypot(r, std::sqrt(1. - x * x) * eps * legendre(n, x).slope);
        volume += rule.weights[i] * r * r * r;
      }
    return surface / std::pow(volume, (dim - 1.) / dim);
  }

  /**
   * Damping over nu of the potential r^n Y_n in the unit ball: the dissipation is nu int d|v|^2/dr over the surface
   * (Lamb, 329), the kinetic energy 1/2 int phi dphi/dr. The dissipation is half of that in the mean of a period, and
   * the amplitude falls half as fast as the energy.
   */
  double
  damping_by_dissipation(const int dim, const int n)
  {
    const GaussRule rule = gauss_rule(60);
    double loss = 0., energy = 0.;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
      {
        const double x = 2. * rule.points[i] - 1., angle = 2. * pi * rule.points[i];
        const double along  = dim == 2 ? std::cos(n * angle) : legendre(n, x).value;
        const double across = dim == 2 ? -n * std::sin(n * angle)
                                       : std::sqrt(1. - x * x) * legendre(n, x).slope;
        const double square = n * n * along * along + across * across; // |v|^2 goes as r^(2 n - 2)
        loss += rule.weights[i] * (2. * n - 2.) * square;
        energy += rule.weights[i] * 0.5 * n * along * along;
      }
    return loss / (4. * energy);
  }
} // namespace

TEST_CASE("A drop swings as its surface and inertia say", "[verification]")
{
  // gamma times the second derivative of the surface at constant volume, by its integral for two shapes near a
  // sphere, over rho times the inertia of the potential flow, which is 1/n; and waves of a plane for large n.
  for (const int dim : {2, 3})
    {
      Drop drop;
      drop.dim = dim;
      for (const int n : {2, 3, 4})
        {
          constexpr double eps = 2e-3;
          double mean          = 0.; // of Y_n^2
          const GaussRule rule = gauss_rule(60);
          for (std::size_t i = 0; i < rule.points.size(); ++i)
            mean += rule.weights[i] * std::pow(dim == 2
                                                 ? std::cos(2. * pi * n * rule.points[i])
                                                 : legendre(n, 2. * rule.points[i] - 1.).value,
                                               2);
          const double spring =
            (relative_surface(dim, n, eps) + relative_surface(dim, n, -eps) - 2.) / (eps * eps);
          const double mass = mean / n;
          const double unit = drop.capillary_speed() / drop.radius;
          CHECK(std::pow(drop_frequency(drop, n) / unit, 2) == Approx(spring / mass).epsilon(1e-3));
        }
      const double k = 200. / drop.radius;
      CHECK(drop_frequency(drop, 200) ==
            Approx(std::sqrt(drop.surface_tension * std::pow(k, 3) / drop.density)).epsilon(0.02));
      CHECK(drop_frequency(drop, 1) == 0.);
    }
}

TEST_CASE("A drop loses what its potential flow dissipates", "[verification]")
{
  // The amplitude falls by half the dissipation over the energy: 4 and 5 nu/R^2 for n = 2. The whole equation has that as
  // its limit for small viscosity, where its correction goes as nu^(3/2).
  for (const int dim : {2, 3})
    for (const int n : {2, 3, 4})
      {
        Drop drop;
        drop.dim       = dim;
        drop.viscosity = 1e-11;
        CHECK(drop_damping(drop, n) * drop.radius * drop.radius / drop.viscosity ==
              Approx(damping_by_dissipation(dim, n)).epsilon(1e-9));
        const std::complex<double> s = drop_rate(drop, n);
        CHECK(-s.real() == Approx(drop_damping(drop, n)).epsilon(0.01));
        CHECK(s.imag() == Approx(drop_frequency(drop, n)).epsilon(1e-5));
      }
  CHECK(drop_damping({2, 1., 1., 1., 1.}, 2) == 4.);
  CHECK(drop_damping({3, 1., 1., 1., 1.}, 2) == 5.);
}

TEST_CASE("A viscous drop swings more slowly", "[verification]")
{
  // Short waves on it are those of a plane: Lamb's equation. Long ones, n = 2, have a frequency below that without
  // viscosity and less damping than the potential flow.
  for (const int dim : {2, 3})
    {
      Drop drop;
      drop.dim       = dim;
      drop.viscosity = std::sqrt(drop.density * drop.surface_tension * 2. * drop.radius / 12000.) /
                       drop.density;
      const std::complex<double> s = drop_rate(drop, 2);
      CHECK(s.imag() < drop_frequency(drop, 2));
      CHECK(s.imag() > 0.998 * drop_frequency(drop, 2));
      CHECK(-s.real() < drop_damping(drop, 2));
      CHECK(-s.real() > 0.93 * drop_damping(drop, 2));

      const double k               = 400. / drop.radius;
      drop.viscosity               = 0.05 * drop.capillary_speed() * drop.radius / 400. / 20.;
      const double w2              = drop.surface_tension * std::pow(k, 3) / drop.density;
      const double nu              = drop.viscosity;
      const std::complex<double> t = drop_rate(drop, 400), m = std::sqrt(k * k + t / nu);
      const std::complex<double> left = std::pow(t + 2. * nu * k * k, 2) -
                                        4. * nu * nu * std::pow(k, 3) * m + w2;
      CHECK(std::abs(left) < 0.02 * w2);
    }
}
