#pragma once

#include <magmpm/base/tensor.h>
#include <magmpm/materials/material_parameters.h>
#include <magmpm/materials/von_mises_stress.h>

#include <cmath>

namespace magmpm
{
  /**
   * Compressible viscous fluid whose pressure follows the volume, Eq. (19-21) of Sun et al. 2021:
   *   sigma = mu_N (grad v + grad v^T) - K (1 - J) I + zeta div v I.
   * Compressed (J < 1), its pressure p = K (1 - J) is positive and pushes outwards. The pressure
   * derives from the energy K/2 (1 - J)^2 per undeformed volume. The bulk viscosity zeta damps sound, which is
   * slower than that of the real fluid and would be heard for ever. In 2D: plane strain.
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
    double bulk_viscosity;    ///< zeta [Pa s]
    double density;           ///< undeformed [kg/m^3]

    /** The same law for numbers of another type. */
    template <typename Other>
    ViscoelasticFluid<dim, Other>
    with_number() const
    {
      return {bulk_modulus, dynamic_viscosity, bulk_viscosity, density};
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
      const Number normal = volume_ratio *
                            cauchy_stress_out_of_plane(volume_ratio, velocity_gradient);
      for (int i = 0; i < dim; ++i)
        stress(i, i) += normal;
      return stress;
    }

    /** sigma_zz of plane strain [Pa], and what all normal stresses have without shear. */
    Number
    cauchy_stress_out_of_plane(const State &volume_ratio,
                               const Matrix<dim, Number> &velocity_gradient) const
    {
      return bulk_viscosity * trace(velocity_gradient) - pressure(volume_ratio);
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

    /** Of the shear that is damped as fast as a wave of sound, mu_N + zeta/2 [Pa s]. */
    double
    viscosity() const
    {
      return dynamic_viscosity + 0.5 * bulk_viscosity;
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
    const double wave_speed = std::sqrt(parameters.bulk_modulus / density);
    return {parameters.bulk_modulus,
            parameters.viscosity,
            parameters.sound_damping_length * density * wave_speed,
            density};
  }
} // namespace magmpm
