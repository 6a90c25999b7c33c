#pragma once

#include <magmpm/base/simd.h>

#include <limits>

/** Elementary functions of Simd without a branch or a table; found wherever a Simd is passed. */
namespace magmpm
{
  namespace simd_bits
  {
    // A double has 52 bits of the fraction below 11 of the exponent, which counts from 1023.
    inline constexpr std::uint64_t exponent_of_one = 1023ull << 52;
    inline constexpr std::uint64_t exponent_mask   = 0xfffull << 52;
    inline constexpr std::uint64_t sqrt_half       = 0x3fe6a09e667f3bcdull;

    /** The bits of 2^52. The last bit of its fraction is worth one: the fraction is an integer. */
    inline constexpr std::uint64_t integer_exponent = (1023ull + 52ull) << 52;
  } // namespace simd_bits

  /**
   * Natural logarithm to 5e-16 (relative, also close to one). NaN where x < 0, minus infinity where x
   * is zero or smaller than 2.2e-308, the normal numbers.
   */
  template <int width>
  inline Simd<double, width>
  log(const Simd<double, width> &x)
  {
    using namespace simd_bits;
    using Numbers = Simd<double, width>;
    using Limits  = std::numeric_limits<double>;

    // x = 2^e m with m in [sqrt(1/2), sqrt(2)), so that ln x = e ln 2 + 2 artanh((m - 1)/(m + 1)).
    const auto shifted = x.bits() - sqrt_half + exponent_of_one;
    const Numbers m    = Numbers::from_bits(x.bits() - (shifted & exponent_mask) + exponent_of_one);
    const Numbers e    = Numbers::from_bits((shifted >> 52) | integer_exponent) - (0x1p52 + 1023.);
    const Numbers z    = (m - 1.) / (m + 1.);
    const Numbers z_square = z * z;
    Numbers series         = 1. / 19.;
    for (int n = 17; n > 0; n -= 2)
      series = series * z_square + 1. / n;
    const Numbers logarithm = 0.693147180559945309417 * e + 2. * z * series;

    const Numbers special = Numbers::select(
      x > 1., x, Numbers::select(0. <= x, -Limits::infinity(), Limits::quiet_NaN()));
    return Numbers::select((Limits::min() <= x) & (x <= Limits::max()), logarithm, special);
  }

  /** e^x to 4e-16 (relative); zero below x = -708 and infinite above 709. */
  template <int width>
  inline Simd<double, width>
  exp(const Simd<double, width> &x)
  {
    using namespace simd_bits;
    using Numbers = Simd<double, width>;

    // x = n ln 2 + r with |r| <= ln(2)/2; ln 2 in two parts, of which n times the first is exact.
    constexpr double to_integer =
      0x1.8p52; // added to a number, it leaves an integer in the last bits
    const Numbers shifted = 1.44269504088896340736 * x + to_integer;
    const Numbers n       = shifted - to_integer;
    const Numbers r       = (x - 0x1.62e42feep-1 * n) - 0x1.a39ef35793c76p-33 * n;
    Numbers series        = 1.;
    for (int k = 13; k > 0; --k)
      series = 1. + series * r * (1. / k);
    const Numbers exponential = Numbers::from_bits(series.bits() + (shifted.bits() << 52));

    const Numbers not_below = Numbers::select(x < -708., 0., exponential);
    const Numbers bounded =
      Numbers::select(x > 709., std::numeric_limits<double>::infinity(), not_below);
    return Numbers::select(x <= x, bounded, x); // a NaN stays NaN NOLINT(misc-redundant-expression)
  }
} // namespace magmpm
