#include "catch.h"

#include <magmpm/base/constants.h>

#include <verification/capillarity/sessile_drop.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

TEST_CASE("The shape of a cap tells its angle", "[verification]")
{
  // The middle of half a disc is 4/(3 pi), of half a ball 3/8 of the radius high, and their rms widths 1/2 and 1/sqrt(5); a
  // whole one is 1 high. Flat caps of slope a are parabolas, a (1 - x^2)/2: 2/5 a/2 over sqrt(1/5) in 2D, a/6 sqrt(6) in 3D.
  const double pi = constants::pi;
  CHECK(cap_ratio(2, 0.5 * pi) == Approx(8. / (3. * pi)).epsilon(1e-10));
  CHECK(cap_ratio(3, 0.5 * pi) == Approx(0.375 * std::sqrt(5.)).epsilon(1e-10));
  CHECK(cap_ratio(2, pi) == Approx(2.).epsilon(1e-10));
  CHECK(cap_ratio(3, pi) == Approx(std::sqrt(5.)).epsilon(1e-10));
  CHECK(cap_ratio(2, 0.01) == Approx(0.002 * std::sqrt(5.)).epsilon(1e-4));
  CHECK(cap_ratio(3, 0.01) == Approx(0.01 / 6. * std::sqrt(6.)).epsilon(1e-4));
  for (const int dim : {2, 3})
    for (const double angle : {0.5, 1.5, 2.6})
      CHECK(cap_angle(dim, cap_ratio(dim, angle)) == Approx(angle).epsilon(1e-9));
}
