#include <magmpm/materials/magnetization.h>
#include <magmpm/materials/parameter_conversion.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** The paper's medium: M_s = 8.2e4 A/m, chi_0 = 0.91, so k2 = 3.3e-5 m/A. */
  const MagneticContent paper = {8.2e4, 0.91};

  const double k2 = 3. * paper.initial_susceptibility / paper.saturation_magnetization;

  template <int dim>
  Vector<dim>
  direction()
  {
    if constexpr (dim == 3)
      return {{2. / 7., -3. / 7., 6. / 7.}};
    else
      return {{0.6, -0.8}};
  }

  template <int dim>
  double
  quadratic_form(const Matrix<dim> &matrix, const Vector<dim> &x)
  {
    return dot(x, matrix * x);
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("magnetization is along the field and L(a) strong",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The textbook form M = M_s (coth a - 1/a) where it is accurate, a = 0.1 to 20: the cancellation
  // leaves 1e-16/a^2.
  for (double a = 0.1; a < 20.; a *= 1.1)
    {
      const Vector<dim> field = (a / k2) * direction<dim>();
      const Vector<dim> m     = magnetization(MagnetizationLaw::langevin, paper, field);
      const double strength   = paper.saturation_magnetization * (1. / std::tanh(a) - 1. / a);
      for (int i = 0; i < dim; ++i)
        CHECK(m[i] == Approx(strength * direction<dim>()[i]).epsilon(1e-13));
    }
}

TEMPLATE_TEST_CASE_SIG("the magnetic tangent is the derivative and the coenergy the potential",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // dM/dH and grad psi = M by central differences of relative step 1e-4, whose error is about
  // (1e-4)^2 = 1e-8 of chi_0 |H|, at fields from nearly linear to saturated.
  const MagnetizationLaw law = GENERATE(MagnetizationLaw::linear, MagnetizationLaw::langevin);
  for (const double a : {1e-3, 0.1, 0.49, 0.51, 3., 30.})
    {
      const Vector<dim> field              = (a / k2) * direction<dim>();
      const MagneticResponse<dim> response = magnetic_response(law, paper, field);
      const Vector<dim> alone              = magnetization(law, paper, field);
      const double step                    = 1e-4 * a / k2;
      Vector<dim> along                    = direction<dim>();
      along[0] += 0.7; // not the direction of the field
      const DirectionalResponse projected = directional_response(law, paper, along, field);
      CHECK(projected.magnetization == Approx(dot(along, response.magnetization)).epsilon(1e-13));
      CHECK(projected.slope == Approx(dot(along, response.tangent * along)).epsilon(1e-12));
      for (int j = 0; j < dim; ++j)
        {
          CHECK(alone[j] == Approx(response.magnetization[j]).epsilon(1e-13));

          Vector<dim> before = field, after = field;
          before[j] -= step;
          after[j] += step;
          const MagneticResponse<dim> low  = magnetic_response(law, paper, before);
          const MagneticResponse<dim> high = magnetic_response(law, paper, after);
          for (int i = 0; i < dim; ++i)
            CHECK(response.tangent(i, j) ==
                  Approx((high.magnetization[i] - low.magnetization[i]) / (2. * step))
                    .margin(3e-8 * norm(alone) / norm(field)));
          CHECK(response.magnetization[j] ==
                Approx((high.coenergy - low.coenergy) / (2. * step)).margin(3e-8 * norm(alone)));
        }
    }
}

TEST_CASE("the coenergy of Langevin's law is M_s/k2 ln(sinh a / a)", "[materials]")
{
  // The closed form where it is accurate and does not overflow, a = 0.3 to 300; and, at a = 1e4,
  // its limit a - ln 2a.
  const double scale = paper.saturation_magnetization / k2;
  for (double a = 0.3; a < 300.; a *= 1.3)
    {
      const auto response =
        magnetic_response<3>(MagnetizationLaw::langevin, paper, (a / k2) * direction<3>());
      CHECK(response.coenergy == Approx(scale * std::log(std::sinh(a) / a)).epsilon(1e-13));
    }
  const auto saturated =
    magnetic_response<3>(MagnetizationLaw::langevin, paper, (1e4 / k2) * direction<3>());
  CHECK(saturated.coenergy == Approx(scale * (1e4 - std::log(2e4))).epsilon(1e-14));
  CHECK(norm(saturated.magnetization) ==
        Approx(paper.saturation_magnetization * (1. - 1e-4)).epsilon(1e-14));
}

TEST_CASE("the magnetic tangent is symmetric and positive at every field", "[materials]")
{
  // Its eigenvalues are 3 chi_0 L/a across and 3 chi_0 L' along the field, both positive. Along the
  // field the tangent is a difference of almost equal numbers at large a, where it may not turn
  // negative by more than rounding of the one across (1e-15).
  for (double a = 1e-12; a < 2e4; a *= 1.7)
    {
      const Vector<3> n = direction<3>();
      const Matrix<3> tangent =
        magnetic_response<3>(MagnetizationLaw::langevin, paper, (a / k2) * n).tangent;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < i; ++j)
          CHECK(tangent(i, j) == tangent(j, i));
      const LangevinFunction law = langevin_function(a * a);
      const double chi           = 3. * paper.initial_susceptibility;
      const double across        = chi * law.over_argument;
      CHECK(quadratic_form(tangent, n) == Approx(chi * law.derivative).margin(2e-15 * across));
      CHECK(quadratic_form(tangent, Vector<3>{{3. / std::sqrt(13.), 2. / std::sqrt(13.), 0.}}) ==
            Approx(across).epsilon(1e-14));
    }
}

TEMPLATE_TEST_CASE_SIG("zero field and zero content give zeros, not 0/0",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // At H = 0 the tangent is chi_0 I for either law; without content, or without susceptibility,
  // there is nothing at all.
  for (const MagnetizationLaw law : {MagnetizationLaw::linear, MagnetizationLaw::langevin})
    {
      const auto at_zero = magnetic_response<dim>(law, paper, {});
      CHECK(norm(at_zero.magnetization) == 0.);
      CHECK(at_zero.coenergy == 0.);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          CHECK(at_zero.tangent(i, j) == Approx(i == j ? 0.91 : 0.).epsilon(1e-15));

      const Vector<dim> field = 1e6 * direction<dim>();
      for (const MagneticContent &nothing : {MagneticContent{}, MagneticContent{8.2e4, 0.}})
        {
          const auto response = magnetic_response<dim>(law, nothing, field);
          CHECK(norm(response.magnetization) == 0.);
          CHECK(norm(magnetization(law, nothing, field)) == 0.);
          CHECK(frobenius_norm(response.tangent) == 0.);
          CHECK(response.coenergy == 0.);
        }
    }
}

TEST_CASE("the linear law is the weak-field limit of Langevin's", "[materials]")
{
  // M = chi_0 H (1 - a^2/15 + ...): at a = 1e-6 the two agree to rounding; the linear one goes on
  // as 0.91 H beyond saturation.
  const Vector<3> weak = (1e-6 / k2) * direction<3>();
  const Vector<3> m    = magnetization(MagnetizationLaw::langevin, paper, weak);
  for (int i = 0; i < 3; ++i)
    CHECK(m[i] == Approx(magnetization(MagnetizationLaw::linear, paper, weak)[i]).epsilon(1e-13));
  const auto linear = magnetic_response<3>(MagnetizationLaw::linear, paper, 1e7 * direction<3>());
  CHECK(norm(linear.magnetization) == Approx(0.91e7).epsilon(1e-14));
  CHECK(linear.coenergy == Approx(0.455e14).epsilon(1e-14));
}

TEST_CASE("the paper's grains have its saturation and susceptibility", "[materials]")
{
  // m = 1.09e-19 A m^2 at 300 K, 3.60e17 grains in a cell of (1/128 m)^3: M_s = 8.2e4 A/m and
  // chi_0 = 0.91 to the two digits known, and mu_0 m/(k_B T) = 3.31e-5 m/A.
  const MagneticParameters grains =
    magnetic_parameters_of_grains(1.09e-19, 3.60e17 * 128. * 128. * 128., 300.);
  CHECK(grains.number_density == Approx(7.55e23).epsilon(1e-3));
  CHECK(grains.saturation_magnetization == Approx(8.2e4).epsilon(5e-3));
  CHECK(grains.initial_susceptibility == Approx(0.91).epsilon(5e-3));
  CHECK(3. * grains.initial_susceptibility / grains.saturation_magnetization ==
        Approx(3.31e-5).epsilon(2e-3));
  CHECK(grains.is_magnetic());
}

TEST_CASE("grains follow back from saturation and susceptibility", "[materials]")
{
  // There and back at another temperature than the paper's: the two conversions are inverse.
  const MagneticParameters there = magnetic_parameters_of_grains(2.5e-19, 1e23, 350.);
  const MagneticParameters back  = magnetic_parameters_of_saturation(
    there.saturation_magnetization, there.initial_susceptibility, 350.);
  CHECK(back.number_density == Approx(1e23).epsilon(1e-14));
  CHECK(back.saturation_magnetization == there.saturation_magnetization);
  CHECK(back.initial_susceptibility == there.initial_susceptibility);

  const MagneticParameters nothing = magnetic_parameters_of_saturation(0., 0., 300.);
  CHECK(nothing.number_density == 0.);
  CHECK(!nothing.is_magnetic());
}

TEST_CASE("elastic moduli convert to Lame's", "[materials]")
{
  // E = 1e5 Pa, nu = 0.3 worked out by hand; and the identities E = mu (3 lambda + 2 mu)/(lambda +
  // mu), nu = lambda/(2 (lambda + mu)) for another pair.
  const LameModuli soft = lame_moduli(1e5, 0.3);
  CHECK(soft.shear_modulus == Approx(1e5 / 2.6).epsilon(1e-15));
  CHECK(soft.lame_lambda == Approx(3e4 / 0.52).epsilon(1e-15));

  const auto [mu, lambda] = lame_moduli(7e3, -0.2);
  CHECK(mu * (3. * lambda + 2. * mu) / (lambda + mu) == Approx(7e3).epsilon(1e-14));
  CHECK(lambda / (2. * (lambda + mu)) == Approx(-0.2).epsilon(1e-14));
}
