#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/materials/material_parameters.h>
#include <magmpm/materials/von_mises_stress.h>

#include <cmath>

namespace magmpm
{
  /**
   * Compressible viscous fluid whose pressure follows the volume, Eq. (19-21) of Sun et al. 2021:
   *   sigma = mu_N (grad v + grad v^T) - K (1 - J) I.
   * Compressed (J < 1), its pressure p = K (1 - J) is positive and pushes outwards. The pressure
   * derives from the energy K/2 (1 - J)^2 per undeformed volume. In 2D: plane strain.
   *
   * @tparam Number  double, or Simd for several particles at once.
   */
  template <int dim, typename Number = double>
  struct ViscoelasticFluid
  {
    /** What a particle stores of its deformation: the volume ratio J. */
    using State = Number;

    static constexpr bool stores_deformation_gradient = false;

    double bulk_modulus;      ///< K [Pa]
    double dynamic_viscosity; ///< mu_N [Pa s]
    double density;           ///< undeformed [kg/m^3]

    /** The same law for numbers of another type. */
    template <typename Other>
    ViscoelasticFluid<dim, Other>
    with_number() const
    {
      return {bulk_modulus, dynamic_viscosity, density};
    }

    static State
    undeformed()
    {
      return 1.;
    }

    Number
    volume_ratio(const State &state) const
    {
      return state;
    }

    /**
     * J after a step: J exp(dt div v), exact at constant div v; it keeps J positive.
     *
     * @param velocity_gradient  (i,j) = dv_i/dx_j [1/s].
     * @param time_step          dt [s].
     */
    State
    advanced(const State &volume_ratio,
             const Matrix<dim, Number> &velocity_gradient,
             const double time_step) const
    {
      using std::exp;
      return volume_ratio * exp(time_step * trace(velocity_gradient));
    }

    /** tau = J sigma [Pa]: the stress per undeformed volume. */
    Matrix<dim, Number>
    kirchhoff_stress(const State &volume_ratio, const Matrix<dim, Number> &velocity_gradient) const
    {
      Matrix<dim, Number> stress = (volume_ratio * dynamic_viscosity) *
                                   (velocity_gradient + transpose(velocity_gradient));
      for (int i = 0; i < dim; ++i)
        stress(i, i) -= volume_ratio * pressure(volume_ratio);
      return stress;
    }

    /** sigma_zz of plane strain [Pa]; used in 2D only. */
    Number
    cauchy_stress_out_of_plane(const State &volume_ratio,
                               const Matrix<dim, Number> & /*velocity_gradient*/) const
    {
      return -pressure(volume_ratio);
    }

    /** Von Mises stress of the Cauchy stress [Pa]: that of the viscous part. */
    Number
    von_mises_stress(const State &volume_ratio, const Matrix<dim, Number> &velocity_gradient) const
    {
      const Matrix<dim, Number> stress = (1. / volume_ratio) *
                                         kirchhoff_stress(volume_ratio, velocity_gradient);
      if constexpr (dim == 3)
        return magmpm::von_mises_stress(stress);
      else
        return magmpm::von_mises_stress(
          stress, cauchy_stress_out_of_plane(volume_ratio, velocity_gradient));
    }

    /** Elastic energy K/2 (1 - J)^2 per undeformed volume [J/m^3]. */
    Number
    energy_density(const State &volume_ratio) const
    {
      return 0.5 * bulk_modulus * (1. - volume_ratio) * (1. - volume_ratio);
    }

    /** Speed of sound in the deformed fluid [m/s]: c^2 = dp/d(density/J) = K J^2/density. */
    Number
    wave_speed(const State &volume_ratio) const
    {
      return volume_ratio * std::sqrt(bulk_modulus / density);
    }

    /** mu_N [Pa s]. */
    double
    viscosity() const
    {
      return dynamic_viscosity;
    }

    /** p = K (1 - J) [Pa]; negative in tension. */
    Number
    pressure(const State &volume_ratio) const
    {
      return bulk_modulus * (1. - volume_ratio);
    }
  };

  /** @param density  of the undeformed body [kg/m^3]. */
  template <int dim>
  inline ViscoelasticFluid<dim>
  make_viscoelastic_fluid(const MaterialParameters &parameters, const double density)
  {
    return {parameters.bulk_modulus, parameters.viscosity, density};
  }
} // namespace magmpm
