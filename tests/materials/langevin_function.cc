#include <magmpm/materials/langevin_function.h>

#include "catch.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>

using namespace magmpm;

namespace
{
  using Precise = boost::multiprecision::cpp_bin_float_100;

  /**
   * The closed forms in 100 digits: at a = 1e-12 they cancel 48 of them (the anisotropy loses a^4),
   * which leaves 50; beyond a = 1e4, exp(-2 a) is nothing.
   */
  struct PreciseLangevin
  {
    explicit PreciseLangevin(const double square)
    {
      const Precise z      = square;
      const Precise a      = sqrt(z);
      const Precise decay  = exp(-2 * a);
      const Precise rest   = 1 - decay;
      over_argument        = ((1 + decay) / rest - 1 / a) / a;
      derivative           = 1 / z - 4 * decay / (rest * rest);
      anisotropy           = (over_argument - derivative) / z;
      integral_over_square = (a + log(rest / (2 * a))) / z;
    }

    Precise over_argument, derivative, anisotropy, integral_over_square;
  };

  double
  relative_error(const double value, const Precise &exact)
  {
    return static_cast<double>(abs((Precise(value) - exact) / exact));
  }
} // namespace

TEST_CASE("Langevin functions agree with high precision from a = 1e-12 to 1e4", "[materials]")
{
  // The four functions against their closed forms in 100 digits, at 2000 values of a a decade and
  // tightly around the place where the series ends. The bounds are twice the errors that rounding
  // leaves: the closed forms lose 1/a^2 (derivative) and 1/a^4 (anisotropy) of 1e-16 at a = 0.5.
  double worst[4]    = {0., 0., 0., 0.};
  const auto compare = [&](const double square) {
    const LangevinFunction law = langevin_function(square);
    const PreciseLangevin exact(square);
    worst[0] = std::max(worst[0], relative_error(law.over_argument, exact.over_argument));
    worst[1] = std::max(worst[1], relative_error(law.derivative, exact.derivative));
    worst[2] = std::max(worst[2], relative_error(law.anisotropy, exact.anisotropy));
    worst[3] = std::max(worst[3],
                        relative_error(law.integral_over_square, exact.integral_over_square));
    CHECK(langevin_over_argument(square) == law.over_argument);
  };
  for (int i = 0; i <= 16 * 250; ++i)
    compare(std::pow(10., 2. * (-12. + i / 250.)));
  for (int i = -500; i <= 500; ++i)
    compare(internal::langevin_series_limit * (1. + 1e-3 * i));

  INFO("L/a " << worst[0] << ", L' " << worst[1] << ", anisotropy " << worst[2] << ", integral "
              << worst[3]);
  CHECK(worst[0] < 1e-14);
  CHECK(worst[1] < 1e-13);
  CHECK(worst[2] < 1e-12);
  CHECK(worst[3] < 1e-14);
}

TEST_CASE("Langevin functions at zero are their limits", "[materials]")
{
  // a = 0 exactly: the first coefficients of the series L = a/3 - a^3/45 + ..., namely L/a = 1/3,
  // L' = 1/3, (L/a - L')/a^2 = 2/45 and, of the integral, 1/6.
  const LangevinFunction law = langevin_function(0.);
  CHECK(law.over_argument == 1. / 3.);
  CHECK(law.derivative == 1. / 3.);
  CHECK(law.anisotropy == Approx(2. / 45.).epsilon(1e-15));
  CHECK(law.integral_over_square == Approx(1. / 6.).epsilon(1e-15));
}

TEST_CASE("Langevin functions do not overflow at any argument", "[materials]")
{
  // a = 1e150, far beyond exp's range: L = 1 - 1/a, so that a L/a = 1; a^2 L' = 1; the integral is
  // a - ln 2a.
  const double a             = 1e150;
  const LangevinFunction law = langevin_function(a * a);
  CHECK(a * law.over_argument == Approx(1.).epsilon(1e-15));
  CHECK(a * a * law.derivative == Approx(1.).epsilon(1e-15));
  CHECK(law.anisotropy >= 0.);
  CHECK(a * law.integral_over_square == Approx(1.).epsilon(1e-15));
}
