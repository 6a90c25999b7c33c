#include <magmpm/lattice/bspline.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** The quadratic B-spline by its own formula, as a function of the distance in units of dx. */
  double
  bspline(const double distance)
  {
    const double x = std::abs(distance);
    if (x < 0.5)
      return 0.75 - x * x;
    return x < 1.5 ? 0.5 * (1.5 - x) * (1.5 - x) : 0.;
  }
} // namespace

TEST_CASE("quadratic B-spline weights are the spline at the three nodes", "[lattice]")
{
  // The weights against the piecewise formula, over all offsets that a point can have. The two are
  // the same polynomials, so only rounding may differ.
  for (double offset = 0.5; offset < 1.5; offset += 1. / 64.)
    {
      double weights[stencil_width];
      quadratic_bspline(offset, weights);
      for (int i = 0; i < stencil_width; ++i)
        CHECK(weights[i] == Approx(bspline(offset - i)).margin(1e-15));
    }
}

TEST_CASE("quadratic B-splines sum to one and reproduce linear functions", "[lattice]")
{
  // Sums of the weights, and of the weights times node number. They are 1 and the point itself for
  // every B-spline of degree >= 1; the second moment is x^2 + 1/4, the D of APIC (D = dx^2/4).
  for (double offset = 0.5; offset < 1.5; offset += 1. / 64.)
    {
      double weights[stencil_width];
      quadratic_bspline(offset, weights);
      double sum = 0., first_moment = 0., spread = 0.;
      for (int i = 0; i < stencil_width; ++i)
        {
          CHECK(weights[i] >= 0.);
          sum += weights[i];
          first_moment += weights[i] * i;
          spread += weights[i] * (i - offset) * (i - offset);
        }
      CHECK(sum == Approx(1.).margin(1e-15));
      CHECK(first_moment == Approx(offset).margin(1e-15));
      CHECK(spread == Approx(0.25).margin(1e-15));
    }
}

TEST_CASE("derivatives of B-spline weights are their difference quotients", "[lattice]")
{
  // A central difference of the weights, which is exact for quadratic functions but for rounding
  // (1e-16 / 1e-3); the derivatives sum to zero, and to one with the node numbers.
  const double h = 1e-3;
  for (double offset = 0.51; offset < 1.49; offset += 1. / 64.)
    {
      double before[stencil_width], after[stencil_width], derivatives[stencil_width];
      quadratic_bspline(offset - h, before);
      quadratic_bspline(offset + h, after);
      quadratic_bspline_derivative(offset, derivatives);
      double sum = 0., first_moment = 0.;
      for (int i = 0; i < stencil_width; ++i)
        {
          CHECK(derivatives[i] == Approx((after[i] - before[i]) / (2. * h)).margin(1e-12));
          sum += derivatives[i];
          first_moment += derivatives[i] * i;
        }
      CHECK(sum == Approx(0.).margin(1e-15));
      CHECK(first_moment == Approx(1.).margin(1e-15));
    }
}
