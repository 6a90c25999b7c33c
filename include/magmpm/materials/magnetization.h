#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/materials/langevin_function.h>
#include <magmpm/materials/material_parameters.h>

namespace magmpm
{
  /**
   * How magnetizable the medium is at a point; both zero in vacuum. The linear law uses the
   * susceptibility only.
   */
  struct MagneticContent
  {
    double saturation_magnetization = 0.; ///< M_s [A/m]
    double initial_susceptibility   = 0.; ///< chi_0 [-]

    bool
    is_magnetic() const
    {
      return saturation_magnetization > 0. && initial_susceptibility > 0.;
    }
  };

  /** Magnetization and what the Newton method needs beside it, at one point. */
  template <int dim>
  struct MagneticResponse
  {
    Vector<dim> magnetization; ///< M [A/m]
    Matrix<dim> tangent;       ///< dM/dH [-], symmetric and positive semidefinite
    double coenergy = 0.;      ///< psi [A^2/m^2] with grad psi = M, zero at H = 0
  };

  namespace internal
  {
    template <int dim>
    inline MagneticResponse<dim>
    linear_response(const MagneticContent &content, const Vector<dim> &field)
    {
      const double chi = content.initial_susceptibility;
      return {chi * field, chi * identity<dim>(), 0.5 * chi * norm_square(field)};
    }

    /** a = k2 H with k2 = 3 chi_0/M_s = mu_0 m/(k_B T), the argument of the Langevin function. */
    template <int dim>
    inline Vector<dim>
    langevin_argument(const MagneticContent &content, const Vector<dim> &field)
    {
      return (3. * content.initial_susceptibility / content.saturation_magnetization) * field;
    }

    template <int dim>
    inline MagneticResponse<dim>
    langevin_response(const MagneticContent &content, const Vector<dim> &field)
    {
      if (!content.is_magnetic())
        return {};
      const Vector<dim> a        = langevin_argument(content, field);
      const LangevinFunction law = langevin_function(norm_square(a));
      const double chi           = 3. * content.initial_susceptibility;
      return {(chi * law.over_argument) * field,
              chi * (law.over_argument * identity<dim>() + (-law.anisotropy) * outer(a, a)),
              chi * law.integral_over_square * norm_square(field)};
    }
  } // namespace internal

  /**
   * Magnetization of a medium, its derivative and its coenergy.
   *   linear:    M = chi_0 H,  psi = chi_0/2 |H|^2;
   *   Langevin:  M = M_s L(a) H/|H|,  a = k2 |H|,  k2 = 3 chi_0/M_s,  psi = M_s/k2 ln(sinh(a)/a),
   * the latter for superparamagnetic media, Eq. (5) of Sun et al. 2021. dM/dH is symmetric positive
   * semidefinite for every H, which makes the Newton matrix of the potential positive definite
   * (appendix A.1). No cancellation and no overflow from a = 0 to 1e150; H may be zero, and so may
   * the content, which gives zeros.
   *
   * @param content  at this point.
   * @param field    H, the total one [A/m].
   */
  template <int dim>
  inline MagneticResponse<dim>
  magnetic_response(const MagnetizationLaw law,
                    const MagneticContent &content,
                    const Vector<dim> &field)
  {
    return law == MagnetizationLaw::linear ? internal::linear_response(content, field)
                                           : internal::langevin_response(content, field);
  }

  /** d.M [A/m] and d.(dM/dH) d for a vector d, cheaper than all of M and its derivative. */
  struct DirectionalResponse
  {
    double magnetization;
    double slope;
  };

  template <int dim>
  inline DirectionalResponse
  directional_response(const MagnetizationLaw law,
                       const MagneticContent &content,
                       const Vector<dim> &direction,
                       const Vector<dim> &field)
  {
    const double along  = dot(direction, field);
    const double square = norm_square(direction);
    if (law == MagnetizationLaw::linear)
      return {content.initial_susceptibility * along, content.initial_susceptibility * square};
    if (!content.is_magnetic())
      return {0., 0.};
    const Vector<dim> a    = internal::langevin_argument(content, field);
    const auto langevin    = langevin_function<false>(norm_square(a));
    const double chi       = 3. * content.initial_susceptibility;
    const double projected = dot(direction, a);
    return {chi * langevin.over_argument * along,
            chi * (langevin.over_argument * square - langevin.anisotropy * projected * projected)};
  }

  /** M [A/m] alone, cheaper. */
  template <int dim>
  inline Vector<dim>
  magnetization(const MagnetizationLaw law,
                const MagneticContent &content,
                const Vector<dim> &field)
  {
    if (law == MagnetizationLaw::linear)
      return content.initial_susceptibility * field;
    if (!content.is_magnetic())
      return {};
    const double square = norm_square(internal::langevin_argument(content, field));
    return (3. * content.initial_susceptibility * langevin_over_argument(square)) * field;
  }
} // namespace magmpm
