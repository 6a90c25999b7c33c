#pragma once

#include <magmpm/base/select.h>
#include <magmpm/base/simd_functions.h>

#include <cmath>

namespace magmpm
{
  /**
   * The Langevin function L(a) = coth a - 1/a and what belongs to it, each divided by the power of
   * a that makes it finite and positive at a = 0; hence no case distinction at zero field.
   *
   * @tparam Number  double, or Simd: of several points.
   */
  template <typename Number = double>
  struct LangevinFunction
  {
    Number over_argument;        ///< L(a)/a, 1/3 at 0
    Number derivative;           ///< L'(a), 1/3 at 0
    Number anisotropy;           ///< (L(a)/a - L'(a))/a^2, 2/45 at 0
    Number integral_over_square; ///< ln(sinh(a)/a)/a^2, 1/6 at 0; the integral of L over a^2
  };

  namespace internal
  {
    /** Below this square of a the power series are used. */
    inline constexpr double langevin_series_limit = 0.25;

    /** L(a) = sum_k c_k a^(2k+1), c_k = 2^(2k+2) B_(2k+2)/(2k+2)!; converges for |a| < pi. */
    inline constexpr int n_langevin_terms                     = 11;
    inline constexpr double langevin_series[n_langevin_terms] = {1. / 3.,
                                                                 -1. / 45.,
                                                                 2. / 945.,
                                                                 -1. / 4725.,
                                                                 2. / 93555.,
                                                                 -1382. / 638512875.,
                                                                 4. / 18243225.,
                                                                 -3617. / 162820783125.,
                                                                 87734. / 38979295480125.,
                                                                 -349222. / 1531329465290625.,
                                                                 310732. / 13447856940643125.};

    /** The power series of all of them. */
    template <typename Number>
    inline LangevinFunction<Number>
    langevin_by_series(const Number square)
    {
      // L' = sum (2k+1) c_k z^k, (L/a - L')/z = -sum 2(k+1) c_(k+1) z^k, integral: c_k/(2k+2).
      LangevinFunction<Number> sum = {0., 0., 0., 0.};
      for (int k = n_langevin_terms - 1; k >= 0; --k)
        {
          const double c           = langevin_series[k];
          sum.over_argument        = sum.over_argument * square + c;
          sum.derivative           = sum.derivative * square + (2 * k + 1) * c;
          sum.integral_over_square = sum.integral_over_square * square + c / (2 * k + 2);
          if (k > 0)
            sum.anisotropy = sum.anisotropy * square - 2 * k * c;
        }
      return sum;
    }

    template <bool with_integral, typename Number>
    inline LangevinFunction<Number>
    langevin_in_closed_form(const Number square)
    {
      using std::exp, std::log, std::sqrt;
      const Number a     = sqrt(square);
      const Number decay = exp(-2. * a);
      const Number rest  = 1. - decay;

      LangevinFunction<Number> result;
      result.over_argument        = ((1. + decay) / rest - 1. / a) / a;
      result.derivative           = 1. / square - 4. * decay / (rest * rest);
      result.anisotropy           = (result.over_argument - result.derivative) / square;
      result.integral_over_square = 0.;
      if constexpr (with_integral)
        result.integral_over_square = (a + log(rest / (2. * a))) / square;
      return result;
    }
  } // namespace internal

  /**
   * All of them, for @p square = a^2 >= 0. In closed form, coth a - 1/a cancels at small a and
   * overflows at large a; here a series in a^2 replaces it below a = 0.5, and e = exp(-2 a) cannot
   * overflow:
   *   L = (1 + e)/(1 - e) - 1/a,
   *   L' = 1/a^2 - 4 e/(1 - e)^2,
   *   ln(sinh(a)/a) = a + ln((1 - e)/(2 a)).
   * For every a the relative error is below 1e-14, that of the anisotropy below 1e-12.
   *
   * @tparam with_integral  false leaves the integral out, which saves a logarithm.
   */
  template <bool with_integral = true, typename Number>
  inline LangevinFunction<Number>
  langevin_function(const Number square)
  {
    // Of several points some may take the series and others the closed form.
    const auto is_small = square < internal::langevin_series_limit;
    if (!any(is_small))
      return internal::langevin_in_closed_form<with_integral>(square);
    const auto series = internal::langevin_by_series(square);
    if (!any(internal::langevin_series_limit <= square))
      return series;
    const auto closed = internal::langevin_in_closed_form<with_integral>(square);
    return {select(is_small, series.over_argument, closed.over_argument),
            select(is_small, series.derivative, closed.derivative),
            select(is_small, series.anisotropy, closed.anisotropy),
            select(is_small, series.integral_over_square, closed.integral_over_square)};
  }
} // namespace magmpm
