#pragma once

#include <magmpm/materials/magnetization.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  /**
   * A medium of two layers at one point: what the potential problem and the force need of it.
   *
   * @tparam Number  double, or Simd: at several points, as in all that follows.
   */
  template <int dim, typename Number = double>
  struct LaminateResponse
  {
    /** Mean M [A/m], d(mean M)/dH and the coenergy of the medium, W - |H|^2/2 below. */
    MagneticResponse<dim, Number> mean;

    /** s nu [A/m]: the field is H + (1 - f) s nu in the material and H - f s nu beside it. */
    Vector<dim, Number> jump;
  };

  /** A fraction above this is 1 but for its rounding: the point is no mixture. */
  inline constexpr double nearly_full = 1. - 1e-12;

  namespace internal
  {
    /**
     * The zero of s + nu.M(H + (1-f) s nu), which grows in s at least as fast as s itself. By this, and
     * since s = 0 gives b = nu.M(H), it lies between -b and 0: Newton's method inside this bracket,
     * which halves it where a step would leave it. Zero where there are no two phases.
     */
    template <int dim, typename Number>
    inline Number
    laminate_jump(const MagnetizationModel &law,
                  const MagneticContentOf<Number> &content,
                  const Number fraction,
                  const Vector<dim, Number> &normal,
                  const Vector<dim, Number> &field)
    {
      using std::max;
      constexpr int max_iterations = 60; // halving alone reaches the tolerance

      Number jump = 0., start = 0., low = 0., high = 0.;
      auto is_open = (fraction > 0.) & (fraction < nearly_full); // each point stops by itself
      for (int i = 0; i < max_iterations && any(is_open); ++i)
        {
          const Vector<dim, Number> inside = field + ((1. - fraction) * jump) * normal;
          const auto response              = directional_response(law, content, normal, inside);
          const Number value               = jump + response.magnetization;
          if (i == 0)
            {
              start = max(value, -value);
              low   = -max(value, Number(0.));
              high  = max(-value, Number(0.));
            }
          const auto is_above  = value > 0.;
          high                 = select(is_above, jump, high);
          low                  = select(is_above, low, jump);
          const Number newton  = jump - value / (1. + (1. - fraction) * response.slope);
          const auto is_inside = (low <= newton) & (newton <= high);
          const Number next    = select(is_inside, newton, 0.5 * (low + high));
          // After a Newton step the error is of the order of the square of the change.
          const Number tolerated = select(is_inside, Number(1e-7), Number(1e-13)) * start;
          const Number change    = max(next - jump, jump - next);
          jump                   = select(is_open, next, jump);
          is_open                = is_open & (change > tolerated);
        }
      return jump;
    }
  } // namespace internal

  /**
   * A laminate of magnetic material (fraction f of the volume) and vacuum with layers across nu: what
   * a point of the lattice near a surface is made of. Across the layers the normal component of B and
   * the tangential one of H are continuous, which is the minimum over the jump s of
   *   W(H) = f [|H1|^2/2 + psi(H1)] + (1-f) |H2|^2/2,   H1 = H + (1-f) s nu,   H2 = H - f s nu,
   * hence s + nu.M(H1) = 0, with
   *   W - |H|^2/2 = f psi(H1) + f (1-f) s^2/2,    mean M = f M(H1),
   *   d(mean M)/dH = f [K - (1-f) (K nu)(K nu)^T / (1 + (1-f) nu.K nu)],   K = dM/dH at H1.
   * W is convex in H, so the Jacobian of the potential problem stays positive definite. f = 1 is the
   * material alone; |nu| < 1, where the normal vanishes, leads over to a fine mixture, M = f M(H).
   *
   * @param content   of the material phase.
   * @param fraction  f, 0 to 1.
   * @param normal    nu, of length at most 1; its sign does not matter.
   * @param field     H, the mean over both phases [A/m].
   */
  template <int dim, typename Number>
  inline LaminateResponse<dim, Number>
  laminate_response(const MagnetizationModel &law,
                    const MagneticContentOf<Number> &content,
                    const Number fraction,
                    const Vector<dim, Number> &normal,
                    const Vector<dim, Number> &field)
  {
    if (!any(fraction > 0.))
      return {};

    const Number rest = 1. - fraction;
    const Number jump = internal::laminate_jump(law, content, fraction, normal, field);

    LaminateResponse<dim, Number> result;
    result.jump = jump * normal;
    const MagneticResponse<dim, Number> inside =
      magnetic_response(law, content, field + rest * result.jump);
    const Vector<dim, Number> k_normal = inside.tangent * normal;
    const Number softening             = rest / (1. + rest * dot(normal, k_normal));

    result.mean.magnetization = fraction * inside.magnetization;
    result.mean.tangent  = fraction * (inside.tangent + (-softening) * outer(k_normal, k_normal));
    result.mean.coenergy = fraction * (inside.coenergy + 0.5 * rest * jump * jump);
    return result;
  }
} // namespace magmpm
