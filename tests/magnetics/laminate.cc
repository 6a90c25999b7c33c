#include "catch.h"

#include <magmpm/magnetics/laminate.h>

#include <vector>

using namespace magmpm;

namespace
{
  constexpr double k2 = 3.31e-5; ///< mu_0 m/(k_B T) of the paper's grains [m/A]

  MagneticContent
  grains(const double susceptibility)
  {
    return {3. * susceptibility / k2, susceptibility};
  }

  template <int dim>
  Vector<dim>
  unit_vector(const double angle)
  {
    Vector<dim> direction;
    direction[0] = std::cos(angle);
    direction[1] = std::sin(angle);
    if (dim == 3)
      {
        direction *= 0.8;
        direction[dim - 1] = 0.6;
      }
    return direction;
  }

  struct Case
  {
    MagnetizationLaw law;
    double susceptibility, argument, fraction;
  };

  /** From soft to stiff, weak to saturated, nearly empty to nearly full. */
  std::vector<Case>
  all_cases()
  {
    std::vector<Case> cases;
    for (const double susceptibility : {0.91, 1000.})
      for (const double argument : {1e-3, 1., 30., 1e4})
        for (const double fraction : {1e-6, 0.3, 0.5, 0.999})
          cases.push_back({MagnetizationLaw::langevin, susceptibility, argument, fraction});
    for (const double fraction : {1e-6, 0.3, 0.999})
      cases.push_back({MagnetizationLaw::linear, 1000., 1., fraction});
    return cases;
  }

  /** W(H) - |H|^2/2 for a given jump, which the laminate minimizes. */
  template <int dim>
  double
  excess_energy(const Case &c,
                const Vector<dim> &normal,
                const Vector<dim> &field,
                const double jump)
  {
    const Vector<dim> inside = field + ((1. - c.fraction) * jump) * normal;
    return c.fraction * (magnetic_response<dim>(c.law, grains(c.susceptibility), inside).coenergy +
                         0.5 * (1. - c.fraction) * jump * jump);
  }

  template <int dim>
  LaminateResponse<dim>
  respond(const Case &c, const Vector<dim> &normal, const Vector<dim> &field)
  {
    return laminate_response<dim>(c.law, grains(c.susceptibility), c.fraction, normal, field);
  }
} // namespace

// Across the layers the normal component of B and along them H is the same in both phases: the
// conditions at the surface of a magnet, which the laminate resolves inside a cell. They hold exactly,
// from vacuum to stiff and from weak to saturated material.
TEMPLATE_TEST_CASE_SIG("A laminate keeps normal B and tangential H",
                       "[magnetics]",
                       ((int dim), dim),
                       2,
                       3)
{
  for (const Case &c : all_cases())
    {
      const Vector<dim> normal             = unit_vector<dim>(0.4),
                        field              = (c.argument / k2) * unit_vector<dim>(1.3);
      const LaminateResponse<dim> response = respond<dim>(c, normal, field);
      const Vector<dim> inside             = field + (1. - c.fraction) * response.jump;
      const Vector<dim> outside            = field - c.fraction * response.jump;
      const Vector<dim> m =
        magnetic_response<dim>(c.law, grains(c.susceptibility), inside).magnetization;

      CAPTURE(dim, c.susceptibility, c.argument, c.fraction);
      CHECK(dot(normal, inside + m) ==
            Approx(dot(normal, outside)).epsilon(1e-11).margin(1e-11 * norm(m)));
      const Vector<dim> tangential = response.jump - dot(normal, response.jump) * normal;
      CHECK(norm(tangential) <= 1e-12 * norm(field));
      CHECK(norm(response.mean.magnetization - c.fraction * m) <= 1e-11 * norm(m));
    }
}

// The jump minimizes the energy, so any other costs more; and mean M is the derivative of what is
// left, its tangent the second one: both agree with differences to their accuracy.
TEMPLATE_TEST_CASE_SIG("A laminate derives from a convex energy",
                       "[magnetics]",
                       ((int dim), dim),
                       2,
                       3)
{
  for (const Case &c : all_cases())
    for (const double length : {1., 0.5, 0.})
      {
        const Vector<dim> normal       = length * unit_vector<dim>(0.4);
        const Vector<dim> field        = (c.argument / k2) * unit_vector<dim>(1.3);
        const LaminateResponse<dim> at = respond<dim>(c, normal, field);
        CAPTURE(dim, c.susceptibility, c.argument, c.fraction, length);

        const double jump = length > 0. ? dot(normal, at.jump) / (length * length) : 0.;
        const double step = 1e-3 * norm(field);
        for (const double other : {jump - step, jump + step})
          if (length > 0.)
            CHECK(excess_energy<dim>(c, normal, field, other) >= at.mean.coenergy);

        for (int i = 0; i < dim; ++i)
          {
            Vector<dim> change;
            change[i]                        = 1e-5 * norm(field);
            const LaminateResponse<dim> low  = respond<dim>(c, normal, field - change);
            const LaminateResponse<dim> high = respond<dim>(c, normal, field + change);
            const double scale               = norm(at.mean.magnetization);
            CHECK((high.mean.coenergy - low.mean.coenergy) / (2. * change[i]) ==
                  Approx(at.mean.magnetization[i]).epsilon(1e-6).margin(1e-6 * scale));
            for (int j = 0; j < dim; ++j)
              CHECK((high.mean.magnetization[j] - low.mean.magnetization[j]) / (2. * change[i]) ==
                    Approx(at.mean.tangent(j, i)).epsilon(1e-5).margin(1e-5 * scale / norm(field)));
          }
        Vector<dim> arbitrary = unit_vector<dim>(2.2);
        CHECK(dot(arbitrary, at.mean.tangent * arbitrary) >= 0.);
      }
}

// In the limits a laminate is what it is made of: material for f = 1, vacuum for f = 0, and without a
// normal a fine mixture, f M(H). A linear one is known in closed form: fields along the layers see the
// mean of the susceptibilities, across them that of the inverse permeabilities.
TEMPLATE_TEST_CASE_SIG("A laminate has the right limits", "[magnetics]", ((int dim), dim), 2, 3)
{
  const Vector<dim> normal = unit_vector<dim>(0.4);
  const Vector<dim> field  = 1e5 * unit_vector<dim>(1.3);
  const Case full          = {MagnetizationLaw::langevin, 10., 1., 1.};
  const auto material      = magnetic_response<dim>(full.law, grains(10.), field);
  CHECK(norm(respond<dim>(full, normal, field).mean.magnetization - material.magnetization) == 0.);
  CHECK(norm(respond<dim>(full, normal, field).jump) == 0.);

  const Case empty = {MagnetizationLaw::langevin, 10., 1., 0.};
  CHECK(norm(respond<dim>(empty, normal, field).mean.magnetization) == 0.);
  CHECK(respond<dim>(empty, normal, field).mean.coenergy == 0.);

  const Case mixed = {MagnetizationLaw::langevin, 10., 1., 0.3};
  CHECK(norm(respond<dim>(mixed, Vector<dim>(), field).mean.magnetization -
             0.3 * material.magnetization) <= 1e-12 * norm(material.magnetization));

  // At rest nothing happens.
  CHECK(norm(respond<dim>(mixed, normal, Vector<dim>()).mean.magnetization) == 0.);

  const double chi         = 7.;
  const Case linear        = {MagnetizationLaw::linear, chi, 1., 0.3};
  const Vector<dim> across = dot(normal, field) * normal, along = field - across;
  const Vector<dim> mean = 0.3 * chi * along + (0.3 * chi / (1. + 0.7 * chi)) * across;
  CHECK(norm(respond<dim>(linear, normal, field).mean.magnetization - mean) <= 1e-12 * norm(mean));
}

// Solver and force evaluate several points at once, where each takes its own number of iterations, or
// none. Every lane must get what its point gets alone, whatever lies beside it.
TEST_CASE("A laminate is the same in the lanes of a Simd", "[magnetics]")
{
  using Lanes               = Simd<double, 4>;
  const Vector<3> normal    = unit_vector<3>(0.4);
  const double fractions[4] = {0.3, 1., 0., 0.999};
  const double arguments[4] = {30., 1e-3, 1., 0.6};
  for (const auto law : {MagnetizationLaw::langevin, MagnetizationLaw::linear})
    {
      MagneticContentOf<Lanes> content          = {grains(100.).saturation_magnetization, 100.};
      content.saturation_magnetization.lanes[0] = 0.; // nothing magnetic beside the others
      content.initial_susceptibility.lanes[0]   = 0.;
      Vector<3, Lanes> field, normals;
      for (int lane = 0; lane < 4; ++lane)
        for (int d = 0; d < 3; ++d)
          {
            field[d].lanes[lane]   = arguments[lane] / k2 * unit_vector<3>(1.3)[d];
            normals[d].lanes[lane] = normal[d];
          }
      const auto of_lanes = laminate_response(law, content, Lanes::load(fractions), normals, field);
      for (int lane = 0; lane < 4; ++lane)
        {
          const auto alone = laminate_response<3>(law,
                                                  lane == 0 ? MagneticContent() : grains(100.),
                                                  fractions[lane],
                                                  normal,
                                                  (arguments[lane] / k2) * unit_vector<3>(1.3));
          CAPTURE(lane);
          CHECK(of_lanes.mean.coenergy[lane] == Approx(alone.mean.coenergy).epsilon(1e-12));
          for (int i = 0; i < 3; ++i)
            {
              CHECK(of_lanes.jump[i][lane] == Approx(alone.jump[i]).epsilon(1e-12));
              CHECK(of_lanes.mean.magnetization[i][lane] ==
                    Approx(alone.mean.magnetization[i]).epsilon(1e-12));
              for (int j = 0; j < 3; ++j)
                CHECK(of_lanes.mean.tangent(i, j)[lane] ==
                      Approx(alone.mean.tangent(i, j)).epsilon(1e-11).margin(1e-12));
            }
        }
    }
}
