#include <magmpm/materials/magnetization.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** The paper's medium: M_s = 8.2e4 A/m, chi_0 = 0.91. */
  const MagneticContent paper = {8.2e4, 0.91};

  const double k2 = 3. * paper.initial_susceptibility / paper.saturation_magnetization;

  double
  langevin(const double field)
  {
    return magnetization<2>(MagnetizationLaw::langevin, paper, {{field, 0.}})[0];
  }

  /** The Langevin curve of that medium, with @p n points a unit of a = k2 H up to a = 10. */
  MagnetizationModel
  curve_of_langevin(const int n)
  {
    std::vector<double> fields, magnetizations;
    for (int i = 1; i <= 10 * n; ++i)
      {
        fields.push_back(static_cast<double>(i) / n / k2);
        magnetizations.push_back(langevin(fields.back()));
      }
    return {MagnetizationLaw::table,
            std::make_shared<const MagnetizationCurve>(fields, magnetizations)};
  }

  /** A measured curve as they come: uneven steps, a level part, an S at the start. */
  MagnetizationModel
  rough_curve()
  {
    return {MagnetizationLaw::table,
            std::make_shared<const MagnetizationCurve>(
              std::vector<double>{1e3, 3e3, 1e4, 1.1e4, 5e4, 6e4, 2e5},
              std::vector<double>{500., 2500., 1e4, 1.2e4, 3e4, 3e4, 3.3e4})};
  }

  template <int dim>
  Vector<dim>
  direction()
  {
    if constexpr (dim == 3)
      return {{2. / 7., -3. / 7., 6. / 7.}};
    else
      return {{0.6, -0.8}};
  }
} // namespace

TEST_CASE("a curve of Langevin's law is Langevin's law", "[materials]")
{
  // At the points exactly; between them to the error of cubics, and beyond the last one, at a = 10, to
  // that of its slope, which is of second order and the larger one: from 4 to 8 points a unit of a the
  // error falls fourfold (1.3e-4 and 3.2e-5 of M_s). What else differs there, exp(-20), does not count.
  double error[2] = {0., 0.};
  for (const int i : {0, 1})
    {
      const MagnetizationModel curve = curve_of_langevin(i == 0 ? 4 : 8);
      // A content of the curve's own susceptibility is the curve itself.
      const MagneticContent content = {1., curve.curve->initial_susceptibility()};
      const auto on_curve           = [&](const double field) {
        return magnetization<2>(curve, content, {{field, 0.}})[0];
      };
      for (double a = 0.013; a < 1e3; a *= 1.02)
        error[i] = std::max(
          error[i], std::abs(on_curve(a / k2) - langevin(a / k2)) / paper.saturation_magnetization);
      CHECK(on_curve(3. / k2) == Approx(langevin(3. / k2)).epsilon(1e-12));
      CHECK(curve.curve->initial_susceptibility() == Approx(0.91).epsilon(i == 0 ? 1e-3 : 1e-4));
      CHECK(curve.curve->saturation_magnetization() == Approx(8.2e4).epsilon(1e-3));
    }
  INFO("errors " << error[0] << " and " << error[1]);
  CHECK(error[0] < 3e-4);
  CHECK(error[1] < 0.3 * error[0]);
}

TEMPLATE_TEST_CASE_SIG("the tangent of a curve is its derivative and the coenergy its potential",
                       "[materials]",
                       ((int dim), dim),
                       2,
                       3)
{
  // dM/dH and grad psi = M by central differences, at fields on all pieces, at zero, and beyond the
  // last point; M of a material with twice the curve's susceptibility is twice that of the curve.
  const MagnetizationModel model = rough_curve();
  const MagneticContent content  = {1., 2. * model.curve->initial_susceptibility()};
  for (const double size : {0., 10., 400., 2e3, 7e3, 1.05e4, 3e4, 5.5e4, 1.2e5, 1.9e5, 2.5e5, 1e7})
    {
      CAPTURE(size);
      const Vector<dim> field = size * direction<dim>();
      const auto response     = magnetic_response(model, content, field);
      const auto alone        = magnetization(model, content, field);
      Vector<dim> along       = direction<dim>();
      along[0] += 0.7;
      const auto projected = directional_response(model, content, along, field);
      const double scale   = norm(alone) + 1e-3;
      CHECK(projected.magnetization ==
            Approx(dot(along, response.magnetization)).margin(1e-12 * scale));
      CHECK(projected.slope == Approx(dot(along, response.tangent * along)).epsilon(1e-10));
      const double step = 1e-4 * (size + 1.);
      for (int j = 0; j < dim; ++j)
        {
          CHECK(alone[j] == Approx(response.magnetization[j]).margin(1e-13 * scale));
          Vector<dim> before = field, after = field;
          before[j] -= step;
          after[j] += step;
          const auto low  = magnetic_response(model, content, before);
          const auto high = magnetic_response(model, content, after);
          for (int i = 0; i < dim; ++i)
            CHECK(response.tangent(i, j) ==
                  Approx((high.magnetization[i] - low.magnetization[i]) / (2. * step))
                    .margin(1e-5 * response.tangent(0, 0) + 1e-7 * scale / (size + 1.)));
          CHECK(response.magnetization[j] ==
                Approx((high.coenergy - low.coenergy) / (2. * step)).margin(1e-6 * scale));
        }
    }
  const double on_curve = norm(magnetization(model, content, 3e3 * direction<dim>()));
  CHECK(on_curve == Approx(2. * 2500.));
}

TEST_CASE("a curve rises wherever its points do", "[materials]")
{
  // The slope is never negative, so that the Newton matrix stays positive definite, and M passes every
  // point; the level part between 5e4 and 6e4 is level. Beyond the end M saturates.
  const MagnetizationCurve curve = *rough_curve().curve;
  for (double field = 1.; field < 1e7; field *= 1.003)
    CHECK(curve.evaluate(field * field).slope >= 0.);
  CHECK(curve.evaluate(1.1e4 * 1.1e4).over_field == Approx(1.2e4 / 1.1e4));
  CHECK(curve.evaluate(5.5e4 * 5.5e4).over_field == Approx(3e4 / 5.5e4));
  CHECK(curve.evaluate(5.5e4 * 5.5e4).slope == 0.);
  CHECK(1e12 * curve.evaluate(1e24).over_field == Approx(curve.saturation_magnetization()));
  CHECK(curve.saturation_magnetization() > 3.3e4);
  CHECK(curve.evaluate(0.).over_field == Approx(curve.initial_susceptibility()));
}

TEST_CASE("a curve in SIMD lanes is the curve", "[materials]")
{
  // Each lane in another piece, one beyond the end, one without field.
  const MagnetizationCurve curve = *rough_curve().curve;
  Simd<double, 4> squares;
  const double fields[] = {0., 2e3, 5.2e4, 9e5};
  for (int lane = 0; lane < 4; ++lane)
    squares.lanes[lane] = fields[lane] * fields[lane];
  const auto lanes = curve.evaluate(squares);
  for (int lane = 0; lane < 4; ++lane)
    {
      const auto alone = curve.evaluate(fields[lane] * fields[lane]);
      CHECK(lanes.over_field[lane] == Approx(alone.over_field).epsilon(1e-14));
      CHECK(lanes.slope[lane] == Approx(alone.slope).epsilon(1e-14));
      CHECK(lanes.coenergy[lane] == Approx(alone.coenergy).epsilon(1e-14));
    }
}
