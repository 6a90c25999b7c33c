#pragma once

#include <magmpm/base/select.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace magmpm
{
  /**
   * M(|H|) and what belongs to it, each divided by what makes it finite at H = 0.
   *
   * @tparam Number  double, or Simd: at several points.
   */
  template <typename Number = double>
  struct CurveValues
  {
    Number over_field; ///< M/|H| [-]
    Number slope;      ///< dM/d|H| [-]
    Number anisotropy; ///< (M/|H| - dM/d|H|)/|H|^2 [m^2/A^2]
    Number coenergy;   ///< integral of M from 0 to |H| [A^2/m^2]
  };

  /**
   * A measured magnetization curve M(|H|), interpolated between its points by cubic polynomials that
   * rise where the points do (Fritsch and Butland 1984, "pchip"), so that dM/dH >= 0 and
   * the coenergy is convex. M is once continuously differentiable, and odd: up to the first point it
   * is a H + c H^3. Beyond the last point (H_n, M_n), where the slope is s,
   *   M = M_n + s H_n (1 - H_n/|H|),
   * which has this slope at first, falling with 1/|H|^2, and saturates at M_n + s H_n, as a Langevin
   * curve does. The coenergy is the exact integral of all this.
   */
  class MagnetizationCurve
  {
  public:
    /** Points of a curve without (0, 0), by their field. */
    static constexpr std::size_t min_points = 2;

    /**
     * @param fields          H [A/m], positive and rising.
     * @param magnetizations  M [A/m] there, positive and not falling; at least min_points of both.
     */
    MagnetizationCurve(const std::vector<double> &fields,
                       const std::vector<double> &magnetizations);

    /** dM/dH at H = 0 [-]. */
    double
    initial_susceptibility() const
    {
      return pieces.front().coefficients[1];
    }

    /** M at H -> infinity, of the extrapolation [A/m]. */
    double
    saturation_magnetization() const
    {
      return saturation;
    }

    /**
     * All of them, for @p square = |H|^2 >= 0 [A^2/m^2].
     *
     * @tparam with_coenergy  false leaves that zero, which saves a logarithm beyond the last point.
     */
    template <bool with_coenergy = true, typename Number>
    CurveValues<Number>
    evaluate(const Number square) const;

  private:
    /** From a point to the next: M = sum of c_j (|H| - begin)^j. */
    struct Piece
    {
      double begin; ///< [A/m]
      double coefficients[4];
      double coenergy; ///< at the begin [A^2/m^2]
    };

    std::vector<Piece> pieces;
    std::vector<double> begins; ///< of the pieces, for the search
    double last_field    = 0.;  ///< H_n [A/m]
    double last_coenergy = 0.;  ///< [A^2/m^2]
    double saturation    = 0.;  ///< M_n + s H_n [A/m]
    double tail          = 0.;  ///< s H_n^2 [A^2/m^2]

    /** The piece of a field up to the last point. */
    const Piece &
    piece_of(const double field) const
    {
      const auto above = std::upper_bound(begins.begin() + 1, begins.end(), field);
      return pieces[above - begins.begin() - 1];
    }

    static void
    set_lane(double &number, const int, const double value)
    {
      number = value;
    }

    template <int width>
    static void
    set_lane(Simd<double, width> &numbers, const int lane, const double value)
    {
      numbers.lanes[lane] = value;
    }

    static double
    lane_of(const double number, const int)
    {
      return number;
    }

    template <int width>
    static double
    lane_of(const Simd<double, width> &numbers, const int lane)
    {
      return numbers[lane];
    }
  };

  template <bool with_coenergy, typename Number>
  inline CurveValues<Number>
  MagnetizationCurve::evaluate(const Number square) const
  {
    using std::sqrt, std::log, std::max, std::min;
    constexpr int n_lanes = sizeof(Number) / sizeof(double); // NOLINT(bugprone-sizeof-expression)

    // Without field M/|H| and dM/d|H| are those next to it; the anisotropy, then all rounding error, is
    // multiplied by |H|^2 in what it serves for.
    const Number safe_square = max(square, Number(1e-200));
    const Number field       = sqrt(safe_square);
    const Number inside      = -max(-field, Number(-last_field));
    Number begin, c[4], start;
    for (int lane = 0; lane < n_lanes; ++lane)
      {
        const Piece &piece = piece_of(lane_of(inside, lane));
        set_lane(begin, lane, piece.begin);
        set_lane(start, lane, piece.coenergy);
        for (int j = 0; j < 4; ++j)
          set_lane(c[j], lane, piece.coefficients[j]);
      }

    const Number t = inside - begin;
    Number value   = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
    CurveValues<Number> result;
    result.slope    = c[1] + t * (2. * c[2] + t * (3. * c[3]));
    result.coenergy = 0.;
    if constexpr (with_coenergy)
      result.coenergy =
        start + t * (c[0] + t * ((1. / 2.) * c[1] + t * ((1. / 3.) * c[2] + t * (0.25 * c[3]))));

    const auto is_beyond = field > last_field;
    if (any(is_beyond))
      {
        value        = select(is_beyond, saturation - tail / field, value);
        result.slope = select(is_beyond, tail / safe_square, result.slope);
        if constexpr (with_coenergy)
          result.coenergy = select(is_beyond,
                                   last_coenergy + saturation * (field - last_field) -
                                     tail * log(field / last_field),
                                   result.coenergy);
      }
    result.over_field = value / field;
    result.anisotropy = (result.over_field - result.slope) / safe_square;
    return result;
  }
} // namespace magmpm
