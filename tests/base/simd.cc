#include <magmpm/base/simd_functions.h>

#include "catch.h"

#include <algorithm>
#include <limits>
#include <vector>

using namespace magmpm;

namespace
{
  constexpr double infinity   = std::numeric_limits<double>::infinity();
  constexpr double not_number = std::numeric_limits<double>::quiet_NaN();

  /** One of the lanes, which must be the same in all of them. */
  double
  lane_of(const SimdDouble &lanes)
  {
    for (int lane = 1; lane < SimdDouble::n_lanes; ++lane)
      CHECK((lanes[lane] == lanes[0] || (std::isnan(lanes[lane]) && std::isnan(lanes[0]))));
    return lanes[0];
  }
} // namespace

// Numbers over all sizes that a double can have; over all fractions of one size; and close to one,
// where the logarithm goes to zero and its relative error is what counts. The standard library is
// right to the last digit or two.
TEST_CASE("The logarithm of lanes is that of the standard library", "[base][simd]")
{
  const auto check = [](const double x) {
    CHECK(std::abs(log(SimdDouble(x))[0] - std::log(x)) <= 5e-16 * std::abs(std::log(x)));
  };
  for (int i = -700; i <= 700; ++i)
    {
      check(std::exp(1.01 * i));
      check(1.06 + 5.01e-4 * i);
      check(1. + 1e-3 * i * std::abs(i) / 490000.);
    }
  CHECK(lane_of(log(SimdDouble(0.))) == -infinity);
  CHECK(lane_of(log(SimdDouble(infinity))) == infinity);
  CHECK(std::isnan(lane_of(log(SimdDouble(-1.)))));
  CHECK(std::isnan(lane_of(log(SimdDouble(-infinity)))));
  CHECK(std::isnan(lane_of(log(SimdDouble(not_number)))));
}

// Over the whole range of doubles to two units in the last place, and the limits that IEEE 754
// wants: 0, infinity and NaN.
TEST_CASE("The exponential of lanes is that of the standard library", "[base][simd]")
{
  for (int i = -700; i <= 700; ++i)
    {
      const double x = 1.01 * i;
      CHECK(std::abs(exp(SimdDouble(x))[0] - std::exp(x)) <= 4e-16 * std::exp(x));
      CHECK(std::abs(exp(SimdDouble(1e-4 * x))[0] - std::exp(1e-4 * x)) <= 4e-16);
    }
  CHECK(lane_of(exp(SimdDouble(0.))) == 1.);
  CHECK(lane_of(exp(SimdDouble(-1000.))) == 0.);
  CHECK(lane_of(exp(SimdDouble(-infinity))) == 0.);
  CHECK(lane_of(exp(SimdDouble(1000.))) == infinity);
  CHECK(std::isnan(lane_of(exp(SimdDouble(not_number)))));
}

// Lane l of four vectors has the numbers 4 l to 4 l + 3, so in memory they must lie in order; a
// stride of 5 leaves a gap that must stay untouched.
TEMPLATE_TEST_CASE_SIG("Lanes go to memory turned around, and come back",
                       "[base][simd]",
                       ((int width), width),
                       2,
                       4,
                       8)
{
  constexpr int stride = 5;
  Simd<double, width> numbers[4];
  for (int i = 0; i < 4; ++i)
    for (int l = 0; l < width; ++l)
      numbers[i].lanes[l] = 4. * l + i;
  double memory[width * stride];
  std::fill(std::begin(memory), std::end(memory), -1.);
  store_transposed(numbers, memory, stride);
  for (int l = 0; l < width; ++l)
    {
      for (int i = 0; i < 4; ++i)
        CHECK(memory[l * stride + i] == 4. * l + i);
      CHECK(memory[l * stride + 4] == -1.);
    }

  Simd<double, width> again[4];
  load_transposed(memory, stride, again);
  for (int i = 0; i < 4; ++i)
    for (int l = 0; l < width; ++l)
      CHECK(again[i][l] == numbers[i][l]);
}

// The first n of the lanes. Places beyond them are not read: the lanes repeat the last number, so
// that nothing but numbers of the caller enters a computation; nor are they written.
TEST_CASE("Part of the lanes can be loaded and stored", "[base][simd]")
{
  constexpr int width = SimdDouble::n_lanes;
  for (int n = 1; n <= width; ++n)
    {
      std::vector<double> numbers(n);
      for (int i = 0; i < n; ++i)
        numbers[i] = 10. + i;
      const SimdDouble loaded = SimdDouble::load(numbers.data(), n);
      for (int lane = 0; lane < width; ++lane)
        CHECK(loaded[lane] == 10. + std::min(lane, n - 1));

      double stored[width];
      std::fill(std::begin(stored), std::end(stored), -1.);
      loaded.store(stored, n);
      for (int lane = 0; lane < width; ++lane)
        CHECK(stored[lane] == (lane < n ? 10. + lane : -1.));
    }
}
