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

  /** That the lanes of a Simd, beside others small and large, get what a number gets. */
  void
  check_lanes(const double square, const LangevinFunction<> &law)
  {
    const double squares[4] = {0., square, 1., 1e8};
    const auto lanes        = langevin_function(Simd<double, 4>::load(squares));
    CHECK(lanes.over_argument[1] == Approx(law.over_argument).epsilon(1e-13));
    CHECK(lanes.derivative[1] == Approx(law.derivative).epsilon(1e-13));
    CHECK(lanes.anisotropy[1] == Approx(law.anisotropy).epsilon(1e-11));
    CHECK(lanes.integral_over_square[1] == Approx(law.integral_over_square).epsilon(1e-13));
    CHECK(lanes.over_argument[0] == Approx(1. / 3.).epsilon(1e-15));
    CHECK(lanes.derivative[3] == Approx(1e-8).epsilon(1e-13));
  }

  /** The largest relative errors over many arguments. */
  class Errors
  {
  public:
    /** Compares the functions at @p square = a^2. */
    void
    include(const double square)
    {
      const LangevinFunction law = langevin_function(square);
      const PreciseLangevin exact(square);
      over_argument = std::max(over_argument,
                               relative_error(law.over_argument, exact.over_argument));
      derivative    = std::max(derivative, relative_error(law.derivative, exact.derivative));
      anisotropy    = std::max(anisotropy, relative_error(law.anisotropy, exact.anisotropy));
      integral      = std::max(integral,
                          relative_error(law.integral_over_square, exact.integral_over_square));
      check_lanes(square, law);
    }

    void
    check(const double bound, const double bound_of_anisotropy) const
    {
      INFO("L/a " << over_argument << ", L' " << derivative << ", integral " << integral
                  << ", anisotropy " << anisotropy);
      CHECK(over_argument < bound);
      CHECK(derivative < bound);
      CHECK(integral < bound);
      CHECK(anisotropy < bound_of_anisotropy);
    }

  private:
    double over_argument = 0., derivative = 0., anisotropy = 0., integral = 0.;
  };
} // namespace

TEST_CASE("Langevin functions agree with high precision from a = 1e-12 to 1e4", "[materials]")
{
  // The four functions against their closed forms in 100 digits, at 250 values a decade. Rounding
  // alone may be left: 1e-16 in the series (1e-15 by the first term that the anisotropy lacks), and
  // in the closed forms, which begin at a = 0.5 and cancel there, some 10 and 1000 times as much.
  Errors series, closed_form;
  for (int i = 0; i <= 16 * 250; ++i)
    {
      const double a = std::pow(10., -12. + i / 250.);
      (a < 0.5 ? series : closed_form).include(a * a);
    }
  series.check(1e-15, 3e-15);
  closed_form.check(2e-14, 1e-12);
}

TEST_CASE("Langevin functions are as good on both sides of the end of the series", "[materials]")
{
  // The same comparison close to a = 0.5, where the series is at its longest reach and the closed
  // form at its greatest loss.
  Errors series, closed_form;
  for (int i = 1; i <= 500; ++i)
    {
      series.include(internal::langevin_series_limit * (1. - 1e-4 * i));
      closed_form.include(internal::langevin_series_limit * (1. + 1e-4 * i));
    }
  series.check(1e-15, 3e-15);
  closed_form.check(2e-14, 1e-12);
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
