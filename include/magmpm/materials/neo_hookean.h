#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/materials/material_parameters.h>
#include <magmpm/materials/von_mises_stress.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  /**
   * Compressible neo-Hookean solid, Eq. (18) of Sun et al. 2021 (with the I that its print lacks):
   *   sigma = mu/J (F F^T - I) + lambda ln(J)/J I,   J = det F.
   * It derives from the energy, per undeformed volume,
   *   psi = mu/2 (tr(F F^T) - 3) - mu ln J + lambda/2 (ln J)^2.
   *
   * In 2D: plane strain, F_zz = 1, per metre of depth. Everything here is defined for J > 0; at
   * J <= 0 the logarithm makes stress and energy NaN, which the caller must look for.
   *
   * @tparam Number  double, or Simd for several particles at once.
   */
  template <int dim, typename Number = double>
  struct NeoHookean
  {
    /** What a particle stores of its deformation: the gradient F. */
    using State = Matrix<dim, Number>;

    static constexpr bool stores_deformation_gradient = true;

    double shear_modulus; ///< mu [Pa]
    double lame_lambda;   ///< lambda [Pa]
    double density;       ///< undeformed [kg/m^3]

    /** The same law for numbers of another type. */
    template <typename Other>
    NeoHookean<dim, Other>
    with_number() const
    {
      return {shear_modulus, lame_lambda, density};
    }

    static State
    undeformed()
    {
      return identity<dim, Number>();
    }

    /** J, deformed over undeformed volume. */
    Number
    volume_ratio(const State &deformation_gradient) const
    {
      return determinant(deformation_gradient);
    }

    /**
     * F after a step: (I + dt grad v) F.
     *
     * @param velocity_gradient  (i,j) = dv_i/dx_j [1/s].
     * @param time_step          dt [s].
     */
    State
    advanced(const State &deformation_gradient,
             const Matrix<dim, Number> &velocity_gradient,
             const double time_step) const
    {
      return (identity<dim, Number>() + time_step * velocity_gradient) * deformation_gradient;
    }

    /** tau = J sigma = mu (F F^T - I) + lambda ln J I [Pa]: the stress per undeformed volume. */
    Matrix<dim, Number>
    kirchhoff_stress(const State &deformation_gradient,
                     const Matrix<dim, Number> & /*velocity_gradient*/) const
    {
      using std::log;
      return stress_with_pressure(deformation_gradient,
                                  lame_lambda * log(volume_ratio(deformation_gradient)));
    }

    /** The same where it is known what is in place of lambda ln J: @p volumetric [Pa]. */
    Matrix<dim, Number>
    stress_with_pressure(const State &deformation_gradient, const Number &volumetric) const
    {
      Matrix<dim, Number> stress = shear_modulus * left_cauchy_green(deformation_gradient);
      const Number isotropic     = volumetric - shear_modulus;
      for (int i = 0; i < dim; ++i)
        stress(i, i) += isotropic;
      return stress;
    }

    /** sigma_zz of plane strain [Pa]; used in 2D only. */
    Number
    cauchy_stress_out_of_plane(const State &deformation_gradient,
                               const Matrix<dim, Number> & /*velocity_gradient*/) const
    {
      using std::log;
      const Number volume_ratio_here = volume_ratio(deformation_gradient);
      return lame_lambda * log(volume_ratio_here) / volume_ratio_here;
    }

    /** Von Mises stress of the Cauchy stress [Pa]. */
    Number
    von_mises_stress(const State &deformation_gradient,
                     const Matrix<dim, Number> &velocity_gradient) const
    {
      const Matrix<dim, Number> stress = (1. / volume_ratio(deformation_gradient)) *
                                         kirchhoff_stress(deformation_gradient, velocity_gradient);
      if constexpr (dim == 3)
        return magmpm::von_mises_stress(stress);
      else
        return magmpm::von_mises_stress(
          stress, cauchy_stress_out_of_plane(deformation_gradient, velocity_gradient));
    }

    /** Elastic energy psi per undeformed volume [J/m^3]; zero when undeformed. */
    Number
    energy_density(const State &deformation_gradient) const
    {
      using std::log;
      Number square = 0.;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          square += deformation_gradient(i, j) * deformation_gradient(i, j);
      const Number log_volume_ratio = log(volume_ratio(deformation_gradient));
      return shear_modulus * (0.5 * (square - dim) - log_volume_ratio) +
             0.5 * lame_lambda * log_volume_ratio * log_volume_ratio;
    }

    /**
     * Speed of the fastest plane wave in the deformed solid [m/s]. In direction n (deformed),
     *   density c^2 = mu n.b n                          across n,
     *   density c^2 = mu (n.b n + 1) + lambda (1 - ln J)  along n,    b = F F^T,
     * of which the larger is taken, with an upper bound for the largest eigenvalue of b: the mean
     * eigenvalue and sqrt((dim-1)/dim) times the norm of the deviator. The bound is exact in 2D and
     * for undeformed and uniaxially stretched material, and at most 4/3 of the eigenvalue in 3D.
     *
     * It is no less than half of dx omega/2 of a particle alone on its lattice,
     *   density (dx omega/2)^2 = 3/2 (2 mu b_max + dim lambda),
     * which does not become slow when expanded, as waves in a body do. The 3/2 is the largest value of
     * dx^2/4 sum_i |grad N_i|^2/N_i, where the particle is halfway between two nodes.
     */
    Number
    wave_speed(const State &deformation_gradient) const
    {
      using std::log, std::max, std::sqrt;
      Matrix<dim, Number> b = left_cauchy_green(deformation_gradient);
      const Number mean     = trace(b) / dim;
      for (int i = 0; i < dim; ++i)
        b(i, i) -= mean;
      const Number largest_stretch_square = mean + std::sqrt((dim - 1.) / dim) * frobenius_norm(b);
      const Number log_volume_ratio       = log(volume_ratio(deformation_gradient));
      const Number along                  = shear_modulus + lame_lambda * (1. - log_volume_ratio);
      const Number in_body                = shear_modulus * largest_stretch_square + max(along, 0.);
      const Number alone                  = 0.375 *
                           (2. * shear_modulus * largest_stretch_square + dim * lame_lambda);
      return sqrt(max(in_body, alone) / density);
    }

    /**
     * kappa [Pa], the part of lambda that acts on the volume ratios of a neighbourhood instead of on a
     * particle's own (particles/smoothed_volume.h): what exceeds 9 mu, which is lambda at Poisson's ratio
     * 0.45. Up to there nothing is smoothed: what bending does to the volume counts then, and a
     * neighbourhood would halve it where it is linear across two cells.
     */
    double
    smoothed_modulus() const
    {
      const double kept     = 9. * shear_modulus;
      const double rounding = 1e-4 * kept; // of moduli that were given as 0.45
      return lame_lambda > kept + rounding ? lame_lambda - kept : 0.;
    }

    /** Dynamic viscosity [Pa s]: none. */
    double
    viscosity() const
    {
      return 0.;
    }

  private:
    /** b = F F^T. */
    static Matrix<dim, Number>
    left_cauchy_green(const State &deformation_gradient)
    {
      return deformation_gradient * transpose(deformation_gradient);
    }
  };

  /** @param density  of the undeformed body [kg/m^3]. */
  template <int dim>
  inline NeoHookean<dim>
  make_neo_hookean(const MaterialParameters &parameters, const double density)
  {
    return {parameters.shear_modulus, parameters.lame_lambda, density};
  }
} // namespace magmpm
