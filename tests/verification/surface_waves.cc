#include "catch.h"

#include <magmpm/base/constants.h>

#include <verification/capillarity/surface_waves.h>

#include <cmath>
#include <complex>
#include <utility>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double mu0 = constants::vacuum_permeability;

  const LayerField no_field = {0., 0., 0.};

  FerrofluidLayer
  langevin_layer()
  {
    FerrofluidLayer layer;
    layer.law    = MagnetizationLaw::langevin;
    layer.medium = {24e3, 1.};
    return layer;
  }

  /**
   * mu_0 M^2 k/(1/(r t) + 1/t') by the equation of Riccati: u = -b_z/(mu_0 k phi) of a potential phi(z) cos(k x) in layers
   * has u' = k (1 + M/H - u^2/(1 + dM/dH)); u = 0 at a shielded face, 1 over vacuum. By Runge and Kutta.
   */
  double
  magnetic_pull(const FerrofluidLayer &layer, const LayerField &state, const double k)
  {
    const auto u_after =
      [k](double u, const double across, const double along, const double thickness) {
        constexpr int n_steps = 4000;
        const double h        = k * thickness / n_steps;
        const auto slope      = [&](const double x) { return across - x * x / along; };
        for (int i = 0; i < n_steps; ++i)
          {
            const double k1 = slope(u), k2 = slope(u + 0.5 * h * k1), k3 = slope(u + 0.5 * h * k2),
                         k4 = slope(u + h * k3);
            u += h / 6. * (k1 + 2. * k2 + 2. * k3 + k4);
          }
        return u;
      };
    const bool is_open  = layer.faces == FieldFaces::open;
    const double inside = u_after(
      is_open ? 1. : 0., 1. + state.magnetization / state.field, 1. + state.slope, layer.depth);
    const double outside = is_open ? 1. : u_after(0., 1., 1., layer.height);
    return mu0 * state.magnetization * state.magnetization * k / (1. / inside + 1. / outside);
  }
} // namespace

TEST_CASE("A deep ferrofluid layer gives way where Cowley and Rosensweig say", "[verification]")
{
  // Of a deep layer M_c^2 = 2/mu_0 (1 + 1/r) sqrt(rho g gamma) at k = sqrt(rho g/gamma), r^2 = (1 + M/H)(1 + dM/dH):
  // 2 for chi = 1. A fluid of 24 kA/m and chi_0 = 1 has 15.80 mT, found before by another program.
  for (const FerrofluidLayer &layer : {FerrofluidLayer(), langevin_layer()})
    {
      const CriticalState critical = critical_state(layer);
      const LayerField &state      = critical.state;
      const double r = std::sqrt((1. + state.magnetization / state.field) * (1. + state.slope));
      CHECK(state.magnetization ==
            Approx(std::sqrt(2. / mu0 * (1. + 1. / r) *
                             std::sqrt(layer.density * layer.gravity * layer.surface_tension)))
              .epsilon(1e-7));
      CHECK(critical.wave_number == Approx(layer.capillary_wave_number()).epsilon(1e-6));
      CHECK(field_of_induction(layer, state.induction()).magnetization ==
            Approx(state.magnetization).epsilon(1e-12));
    }
  CHECK(critical_state(langevin_layer()).state.induction() == Approx(15.80e-3).epsilon(5e-4));
}

TEST_CASE("The wave that grows fastest is shorter above the critical field", "[verification]")
{
  // Without viscosity s^2 goes as k (2 m^2 k - 1 - k^2) in units of k_c, m = M/M_c: largest at (4 m^2 + sqrt(16
  // m^4 - 12))/6. Viscosity slows it and makes it longer.
  FerrofluidLayer layer;
  const double critical = critical_state(layer).state.magnetization;
  for (const double m : {1.02, 1.1, 1.3})
    {
      layer.viscosity        = 0.;
      const LayerField state = field_of_magnetization(layer, m * critical);
      const FastestWave free = fastest_wave(layer, state);
      const double k         = (4. * m * m + std::sqrt(16. * std::pow(m, 4) - 12.)) / 6.;
      CHECK(free.wave_number == Approx(k * layer.capillary_wave_number()).epsilon(1e-6));
      CHECK(std::pow(free.rate, 2) == Approx(layer.gravity * layer.capillary_wave_number() * k *
                                             (2. * m * m * k - 1. - k * k))
                                        .epsilon(1e-6));
      layer.viscosity           = 4e-6;
      const FastestWave viscous = fastest_wave(layer, state);
      CHECK(viscous.rate < free.rate);
      CHECK(viscous.wave_number < free.wave_number);
    }
}

TEST_CASE("Depth and faces change the pull of the field as the potential says", "[verification]")
{
  // The potential of the layers is integrated from floor and ceiling to the surface; a deep one and one of which the
  // faces are open are limits. A thin open sheet, k d = 1e-3, pulls as without permeability, mu_0 M^2 k/2.
  for (FerrofluidLayer layer : {FerrofluidLayer(), langevin_layer()})
    for (const FieldFaces faces : {FieldFaces::open, FieldFaces::shielded})
      for (const double kd : {0.2, 1., 3.})
        {
          const double k         = layer.capillary_wave_number();
          layer.depth            = kd / k;
          layer.height           = 2. * kd / k;
          layer.faces            = faces;
          const LayerField state = field_of_magnetization(layer, 5e3);
          const double pull      = stiffness(layer, no_field, k) - stiffness(layer, state, k);
          CHECK(pull == Approx(magnetic_pull(layer, state, k)).epsilon(1e-9));
        }
  FerrofluidLayer sheet;
  const double k         = sheet.capillary_wave_number();
  sheet.depth            = 1e-3 / k;
  const LayerField state = field_of_magnetization(sheet, 5e3);
  CHECK(stiffness(sheet, no_field, k) - stiffness(sheet, state, k) ==
        Approx(0.5 * mu0 * 25e6 * k).epsilon(2e-3));
}

TEST_CASE("Viscous waves fulfil Lamb's equation", "[verification]")
{
  // With slip at the floor (s + 2 nu k^2)^2 coth(k d) - 4 nu^2 k^3 m coth(m d) + G k/rho = 0, m^2 = k^2 + s/nu, whether
  // the wave swings, grows or creeps; without depth that is Lamb's.
  FerrofluidLayer layer;
  const double k         = layer.capillary_wave_number();
  const LayerField above = field_of_magnetization(layer,
                                                  1.2 * critical_state(layer).state.magnetization);
  for (const double kd : {0.5, 3., 100.})
    for (const double viscosity : {1e-8, 1e-6, 1e-5, 1e-3, 1e-1})
      for (const LayerField &state : {no_field, above})
        {
          layer.depth                  = kd / k;
          layer.viscosity              = viscosity;
          const double g               = stiffness(layer, state, k) * k / layer.density;
          const std::complex<double> s = wave_rate(layer, state, k),
                                     m = std::sqrt(k * k + s / viscosity);
          const std::complex<double> left =
            std::pow(s + 2. * viscosity * k * k, 2) / std::tanh(kd) -
            4. * std::pow(viscosity, 2) * std::pow(k, 3) * m / std::tanh(m * kd / k) + g;
          INFO("k d " << kd << ", nu " << viscosity << ", G k/rho " << g << ", s " << s);
          CHECK(std::abs(left) < 1e-7 * std::abs(g));
          CHECK((g > 0.) == (s.real() < 0.));
        }
}

TEST_CASE("Viscous waves have the limits of the boundary layer and of the film", "[verification]")
{
  // Little viscosity damps a deep wave by 2 nu k^2, and one over a floor that holds the fluid by k sqrt(nu
  // omega/2)/sinh(2 k d) more; much of it lets waves fall by G tanh(k d)/(2 mu k), deep, and by G k^2 d^3/(3 mu) in a film.
  FerrofluidLayer layer;
  const double k     = layer.capillary_wave_number();
  layer.viscosity    = 1e-10;
  const double omega = std::sqrt(-inviscid_rate_square(layer, no_field, k));
  CHECK(wave_rate(layer, no_field, k).real() ==
        Approx(-2. * layer.viscosity * k * k).epsilon(1e-3));
  CHECK(wave_rate(layer, no_field, k).imag() == Approx(omega).epsilon(1e-6));
  layer.floor             = Floor::stick;
  layer.depth             = 1. / k;
  const double in_shallow = std::sqrt(-inviscid_rate_square(layer, no_field, k));
  CHECK(wave_rate(layer, no_field, k).real() ==
        Approx(-k * std::sqrt(0.5 * layer.viscosity * in_shallow) / std::sinh(2.)).epsilon(0.01));

  const double g  = stiffness(layer, no_field, k) / layer.density;
  layer.viscosity = 0.1;
  layer.depth     = 20. / k;
  CHECK(wave_rate(layer, no_field, k).real() ==
        Approx(-0.5 * g / (layer.viscosity * k)).epsilon(1e-3));
  layer.viscosity = 1e-4;
  layer.depth     = 0.05 / k;
  CHECK(wave_rate(layer, no_field, k).real() ==
        Approx(-g * k * k * std::pow(layer.depth, 3) / (3. * layer.viscosity)).epsilon(0.01));
}
