#pragma once

#include <magmpm/materials/magnetization.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace magmpm
{
  /** A medium of two layers at one point: what the potential problem and the force need of it. */
  template <int dim>
  struct LaminateResponse
  {
    /** Mean M [A/m], d(mean M)/dH and the coenergy of the medium, W - |H|^2/2 below. */
    MagneticResponse<dim> mean;

    /** s nu [A/m]: the field is H + (1 - f) s nu in the material and H - f s nu beside it. */
    Vector<dim> jump;
  };

  namespace internal
  {
    /**
     * The zero of s + nu.M(H + (1-f) s nu), which grows in s at least as fast as s itself. By this, and
     * since s = 0 gives b = nu.M(H), it lies between -b and 0: Newton's method inside this bracket,
     * which halves it where a step would leave it.
     */
    template <int dim>
    inline double
    laminate_jump(const MagnetizationLaw law,
                  const MagneticContent &content,
                  const double fraction,
                  const Vector<dim> &normal,
                  const Vector<dim> &field)
    {
      constexpr int max_iterations = 60; // halving alone reaches the tolerance
      constexpr double tolerance   = 1e-13;

      double jump = 0., start = 0., low = 0., high = 0.;
      for (int i = 0; i < max_iterations; ++i)
        {
          const Vector<dim> inside = field + ((1. - fraction) * jump) * normal;
          const DirectionalResponse response =
            directional_response<dim>(law, content, normal, inside);
          const double value = jump + response.magnetization;
          if (i == 0)
            {
              start = std::abs(value);
              low   = std::min(-value, 0.);
              high  = std::max(-value, 0.);
            }
          (value > 0. ? high : low) = jump;
          double next               = jump - value / (1. + (1. - fraction) * response.slope);
          const bool is_newton      = next >= low && next <= high;
          if (!is_newton)
            next = 0.5 * (low + high);
          const double change = std::abs(next - jump);
          jump                = next;
          // After a Newton step the error is of the order of the square of the change.
          if (change <= (is_newton ? 1e-7 : tolerance) * start)
            break;
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
  template <int dim>
  inline LaminateResponse<dim>
  laminate_response(const MagnetizationLaw law,
                    const MagneticContent &content,
                    const double fraction,
                    const Vector<dim> &normal,
                    const Vector<dim> &field)
  {
    if (!(fraction > 0.))
      return {};
    if (fraction >= 1.)
      return {magnetic_response<dim>(law, content, field), Vector<dim>()};

    const double rest = 1. - fraction;
    const double jump = internal::laminate_jump(law, content, fraction, normal, field);

    LaminateResponse<dim> result;
    result.jump = jump * normal;
    const MagneticResponse<dim> inside =
      magnetic_response<dim>(law, content, field + rest * result.jump);
    const Vector<dim> k_normal = inside.tangent * normal;
    const double softening     = rest / (1. + rest * dot(normal, k_normal));

    result.mean.magnetization = fraction * inside.magnetization;
    result.mean.tangent  = fraction * (inside.tangent + (-softening) * outer(k_normal, k_normal));
    result.mean.coenergy = fraction * (inside.coenergy + 0.5 * rest * jump * jump);
    return result;
  }
} // namespace magmpm
