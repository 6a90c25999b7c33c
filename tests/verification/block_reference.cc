#include "catch.h"

#include <verification/magnetostatics/block_reference.h>

using namespace magmpm;
using namespace magmpm::verification;

// The polarizability of a cube of infinite permeability is 3.6443 volumes (Sihvola 2007), that of a square
// bar 2.1884 areas (from the conformal map of its outside); M/H_0 = chi/(1 + chi N) for small chi with N
// = 1/dim by symmetry. A disc as thin as it is wide is between a sphere and a plate; one of 1/500 of its
// width is a plate, M/H_0 = chi/(1 + chi), but for its edge. All of it to 2e-3, from the cells and the box.
TEST_CASE("Finite elements know the moment of blocks", "[verification]")
{
  constexpr double small = 1e-3, large = 1e6;
  const auto factor = [](const double magnetization) {
    return (1. - magnetization / small) / small;
  };
  CHECK(magnetization_of_block<2>({{1., 1.}}, large) == Approx(2.1884).epsilon(2e-3));
  CHECK(factor(magnetization_of_block<2>({{1., 1.}}, small)) == Approx(0.5).epsilon(2e-3));
  CHECK(magnetization_of_block<3>({{1., 1., 1.}}, large, false, 4) == Approx(3.6443).epsilon(2e-3));
  CHECK(factor(magnetization_of_block<3>({{1., 1., 1.}}, small, false, 4)) ==
        Approx(1. / 3.).epsilon(2e-3));
  CHECK(magnetization_of_block<2>({{500., 1.}}, 10., true) == Approx(10. / 11.).epsilon(1.5e-2));
  CHECK(magnetization_of_block<2>({{1., 1.}}, 10., true) > 30. / 13.);
}
