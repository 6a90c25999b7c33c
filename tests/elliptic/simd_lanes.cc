#include "catch.h"

#include <magmpm/elliptic/simd_lanes.h>

#include <array>
#include <limits>
#include <vector>

using namespace magmpm;

namespace
{
  /** Numbers of both signs that differ from lane to lane. */
  template <typename Number>
  CellLanes<Number>
  arbitrary(const double phase)
  {
    CellLanes<Number> lanes;
    for (unsigned int lane = 0; lane < lanes.size(); ++lane)
      lanes[lane] = static_cast<Number>(std::sin(phase + 2.3 * lane));
    return lanes;
  }
} // namespace

// What the potential solver and deal.II do with SIMD lanes is, lane by lane, what they would do with a
// number: the same operations are done with the numbers of each lane.
TEMPLATE_TEST_CASE("Arithmetic of SIMD lanes is that of their numbers", "[elliptic]", float, double)
{
  using Lanes            = CellLanes<TestType>;
  const Lanes a          = arbitrary<TestType>(0.3);
  const Lanes b          = arbitrary<TestType>(1.1);
  const TestType epsilon = 4 * std::numeric_limits<TestType>::epsilon();

  Lanes sum = a, difference = a, product = a, quotient = a;
  sum += b;
  difference -= b;
  product *= b;
  quotient /= b;
  const Lanes mixed = TestType(2.) * a + b * TestType(3.) - a / TestType(4.) + TestType(1.) - (-b);
  const Lanes squared = a * a;
  const Lanes root = std::sqrt(squared), absolute = std::abs(a);
  const Lanes larger = std::max(a, b), smaller = std::min(a, b);
  for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
    {
      CAPTURE(lane);
      const TestType x = a[lane], y = b[lane];
      CHECK(sum[lane] == x + y);
      CHECK(difference[lane] == x - y);
      CHECK(product[lane] == x * y);
      CHECK(quotient[lane] == x / y);
      CHECK(std::abs(mixed[lane] - (2 * x + 3 * y - x / 4 + 1 + y)) < 8 * epsilon);
      CHECK(std::abs(root[lane] - std::abs(x)) < epsilon);
      CHECK(absolute[lane] == std::abs(x));
      CHECK(larger[lane] == std::max(x, y));
      CHECK(smaller[lane] == std::min(x, y));
    }
}

// Lanes are filled from one number, from a list (the rest is zero), from consecutive numbers and from
// numbers anywhere, and written likewise; numbers beside these stay what they were.
TEMPLATE_TEST_CASE("SIMD lanes are loaded and stored in order", "[elliptic]", float, double)
{
  using Lanes                = CellLanes<TestType>;
  constexpr unsigned int n   = Lanes::size();
  constexpr TestType outside = -7.;
  std::vector<TestType> numbers(4 * n + 2, outside);
  for (unsigned int i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<TestType>(i);
  std::array<unsigned int, n> offsets;
  for (unsigned int lane = 0; lane < n; ++lane)
    offsets[lane] = (lane % 2 == 0 ? 3 * lane + 1 : 4 * n - lane);

  Lanes same = TestType(5.), list = {TestType(3.)}, loaded, gathered;
  loaded.load(numbers.data() + 1); // an address that fits no register
  gathered.gather(numbers.data(), offsets.data());
  std::vector<TestType> stored(numbers.size(), outside), scattered(stored);
  loaded.store(stored.data() + 1);
  gathered.scatter(offsets.data(), scattered.data());
  unsigned int n_scattered = 0;
  for (unsigned int i = 0; i < numbers.size(); ++i)
    {
      CAPTURE(i);
      CHECK(stored[i] == (i >= 1 && i <= n ? static_cast<TestType>(i) : outside));
      CHECK((scattered[i] == outside || scattered[i] == static_cast<TestType>(i)));
      n_scattered += scattered[i] != outside;
    }
  CHECK(n_scattered == n);
  for (unsigned int lane = 0; lane < n; ++lane)
    {
      CAPTURE(lane);
      CHECK(same[lane] == 5.);
      CHECK(list[lane] == (lane == 0 ? 3. : 0.));
      CHECK(loaded[lane] == static_cast<TestType>(lane + 1));
      CHECK(gathered[lane] == static_cast<TestType>(offsets[lane]));
    }
  same = TestType(2.);
  CHECK(same[n - 1] == 2.);
}

#if MAGMPM_SIMD_BITS > 0
// A register of the processor, no more and no less: 8 doubles or 16 floats with AVX-512.
TEST_CASE("SIMD lanes fill a register", "[elliptic]")
{
  STATIC_REQUIRE(sizeof(CellLanes<double>) == MAGMPM_SIMD_BITS / 8);
  STATIC_REQUIRE(sizeof(CellLanes<float>) == MAGMPM_SIMD_BITS / 8);
  STATIC_REQUIRE(CellLanes<float>::size() == 2 * CellLanes<double>::size());
  STATIC_REQUIRE(std::is_trivially_copyable<CellLanes<double>>::value);
  STATIC_REQUIRE(std::is_standard_layout<CellLanes<double>>::value);
}
#endif
