#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/materials/langevin_function.h>
#include <magmpm/materials/magnetization_curve.h>
#include <magmpm/materials/material_parameters.h>

#include <memory>
#include <utility>

namespace magmpm
{
  /**
   * How magnetizable the medium is at a point; both zero in vacuum. The linear law uses the
   * susceptibility only.
   *
   * @tparam Number  double, or Simd: at several points, as in all that follows.
   */
  template <typename Number>
  struct MagneticContentOf
  {
    Number saturation_magnetization = 0.; ///< M_s [A/m]
    Number initial_susceptibility   = 0.; ///< chi_0 [-]

    /** A truth value for each point. */
    auto
    is_magnetic() const
    {
      return (saturation_magnetization > 0.) & (initial_susceptibility > 0.);
    }
  };

  using MagneticContent = MagneticContentOf<double>;

  /** Magnetization and what the Newton method needs beside it, at one point. */
  template <int dim, typename Number = double>
  struct MagneticResponse
  {
    Vector<dim, Number> magnetization; ///< M [A/m]
    Matrix<dim, Number> tangent;       ///< dM/dH [-], symmetric and positive semidefinite
    Number coenergy = 0.;              ///< psi [A^2/m^2] with grad psi = M, zero at H = 0
  };

  /** A law with the curve that it needs if it is MagnetizationLaw::table. */
  struct MagnetizationModel
  {
    MagnetizationLaw law;
    std::shared_ptr<const MagnetizationCurve> curve;

    MagnetizationModel(const MagnetizationLaw law,
                       const std::shared_ptr<const MagnetizationCurve> &curve = nullptr)
      : law(law)
      , curve(curve)
    {
    }
  };

  namespace internal
  {
    template <int dim, typename Number>
    inline MagneticResponse<dim, Number>
    linear_response(const MagneticContentOf<Number> &content, const Vector<dim, Number> &field)
    {
      const Number chi = content.initial_susceptibility;
      return {chi * field, chi * identity<dim, Number>(), 0.5 * chi * norm_square(field)};
    }

    /**
     * 3 chi_0, and a = k2 H with k2 = 3 chi_0/M_s = mu_0 m/(k_B T), the argument of the Langevin
     * function; both zero where nothing is magnetic.
     */
    template <int dim, typename Number>
    inline std::pair<Number, Vector<dim, Number>>
    langevin_argument(const MagneticContentOf<Number> &content, const Vector<dim, Number> &field)
    {
      const auto is_magnetic = content.is_magnetic();
      const Number chi       = select(is_magnetic, 3. * content.initial_susceptibility, Number(0.));
      const Number saturation = select(is_magnetic, content.saturation_magnetization, Number(1.));
      return {chi, (chi / saturation) * field};
    }

    template <int dim, typename Number>
    inline MagneticResponse<dim, Number>
    langevin_response(const MagneticContentOf<Number> &content, const Vector<dim, Number> &field)
    {
      const auto [chi, a] = langevin_argument(content, field);
      const auto law      = langevin_function(norm_square(a));
      return {(chi * law.over_argument) * field,
              chi * (law.over_argument * identity<dim, Number>() + (-law.anisotropy) * outer(a, a)),
              chi * law.integral_over_square * norm_square(field)};
    }

    template <int dim, typename Number>
    inline MagneticResponse<dim, Number>
    curve_response(const MagnetizationCurve &curve,
                   const MagneticContentOf<Number> &content,
                   const Vector<dim, Number> &field)
    {
      const Number scale = (1. / curve.initial_susceptibility()) * content.initial_susceptibility;
      const auto law     = curve.evaluate(norm_square(field));
      return {(scale * law.over_field) * field,
              scale * (law.over_field * identity<dim, Number>() +
                       (-law.anisotropy) * outer(field, field)),
              scale * law.coenergy};
    }
  } // namespace internal

  /**
   * Magnetization of a medium, its derivative and its coenergy.
   *   linear:    M = chi_0 H,  psi = chi_0/2 |H|^2;
   *   Langevin:  M = M_s L(a) H/|H|,  a = k2 |H|,  k2 = 3 chi_0/M_s,  psi = M_s/k2 ln(sinh(a)/a),
   * the latter for superparamagnetic media, Eq. (5) of Sun et al. 2021;
   *   table:     M = chi_0/chi_c M_c(|H|) H/|H|,  M_c and chi_c its curve and that curve's slope at 0.
   * dM/dH is symmetric positive
   * semidefinite for every H, which makes the Newton matrix of the potential positive definite
   * (appendix A.1). No cancellation and no overflow from a = 0 to 1e150; H may be zero, and so may
   * the content, which gives zeros.
   *
   * @param content  at this point.
   * @param field    H, the total one [A/m].
   */
  template <int dim, typename Number>
  inline MagneticResponse<dim, Number>
  magnetic_response(const MagnetizationModel &model,
                    const MagneticContentOf<Number> &content,
                    const Vector<dim, Number> &field)
  {
    if (model.law == MagnetizationLaw::linear)
      return internal::linear_response(content, field);
    if (model.law == MagnetizationLaw::table)
      return internal::curve_response(*model.curve, content, field);
    return internal::langevin_response(content, field);
  }

  /** d.M [A/m] and d.(dM/dH) d for a vector d, cheaper than all of M and its derivative. */
  template <typename Number = double>
  struct DirectionalResponse
  {
    Number magnetization;
    Number slope;
  };

  template <int dim, typename Number>
  inline DirectionalResponse<Number>
  directional_response(const MagnetizationModel &model,
                       const MagneticContentOf<Number> &content,
                       const Vector<dim, Number> &direction,
                       const Vector<dim, Number> &field)
  {
    const Number along  = dot(direction, field);
    const Number square = norm_square(direction);
    if (model.law == MagnetizationLaw::linear)
      return {content.initial_susceptibility * along, content.initial_susceptibility * square};
    if (model.law == MagnetizationLaw::table)
      {
        const Number scale = (1. / model.curve->initial_susceptibility()) *
                             content.initial_susceptibility;
        const auto curve = model.curve->template evaluate<false>(norm_square(field));
        return {scale * curve.over_field * along,
                scale * (curve.over_field * square - curve.anisotropy * along * along)};
      }
    const auto [chi, a]    = internal::langevin_argument(content, field);
    const auto langevin    = langevin_function<false>(norm_square(a));
    const Number projected = dot(direction, a);
    return {chi * langevin.over_argument * along,
            chi * (langevin.over_argument * square - langevin.anisotropy * projected * projected)};
  }

  /** M [A/m] alone, cheaper. */
  template <int dim, typename Number>
  inline Vector<dim, Number>
  magnetization(const MagnetizationModel &model,
                const MagneticContentOf<Number> &content,
                const Vector<dim, Number> &field)
  {
    if (model.law == MagnetizationLaw::linear)
      return content.initial_susceptibility * field;
    if (model.law == MagnetizationLaw::table)
      return ((1. / model.curve->initial_susceptibility()) * content.initial_susceptibility *
              model.curve->template evaluate<false>(norm_square(field)).over_field) *
             field;
    const auto [chi, a] = internal::langevin_argument(content, field);
    return (chi * langevin_function<false>(norm_square(a)).over_argument) * field;
  }
} // namespace magmpm
