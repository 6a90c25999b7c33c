#pragma once

#include <magmpm/base/constants.h>
#include <magmpm/materials/material_parameters.h>

namespace magmpm
{
  /** Moduli of an isotropic solid in the form that the laws use [Pa]. */
  struct LameModuli
  {
    double shear_modulus; ///< mu
    double lame_lambda;   ///< lambda
  };

  /**
   * mu = E/(2 (1 + nu)),  lambda = E nu/((1 + nu) (1 - 2 nu)).
   *
   * @param youngs_modulus  E [Pa], positive.
   * @param poissons_ratio  nu [-], above -1 and below 1/2.
   */
  inline LameModuli
  lame_moduli(const double youngs_modulus, const double poissons_ratio)
  {
    return {youngs_modulus / (2. * (1. + poissons_ratio)),
            youngs_modulus * poissons_ratio / ((1. + poissons_ratio) * (1. - 2. * poissons_ratio))};
  }

  /**
   * Magnetic content of a medium with superparamagnetic grains, the paper's way of giving it:
   *   M_s = n m,  chi_0 = mu_0 n m^2/(3 k_B T).
   *
   * @param grain_moment    m [A m^2].
   * @param number_density  n, grains per volume of undeformed material [1/m^3].
   * @param temperature     T [K], positive.
   */
  inline MagneticParameters
  magnetic_parameters_of_grains(const double grain_moment,
                                const double number_density,
                                const double temperature)
  {
    const double saturation_magnetization = number_density * grain_moment;
    return {saturation_magnetization,
            constants::vacuum_permeability * saturation_magnetization * grain_moment /
              (3. * constants::boltzmann * temperature),
            number_density};
  }

  /**
   * The inverse: grains that have a given saturation and susceptibility at a temperature,
   *   m = 3 k_B T chi_0/(mu_0 M_s),  n = M_s/m.
   * Without either of them the medium is not magnetic: the number density is zero.
   *
   * @param saturation_magnetization  M_s [A/m].
   * @param initial_susceptibility    chi_0 [-].
   * @param temperature               T [K], positive.
   */
  inline MagneticParameters
  magnetic_parameters_of_saturation(const double saturation_magnetization,
                                    const double initial_susceptibility,
                                    const double temperature)
  {
    double number_density = 0.;
    if (saturation_magnetization > 0. && initial_susceptibility > 0.)
      {
        const double grain_moment = 3. * constants::boltzmann * temperature *
                                    initial_susceptibility /
                                    (constants::vacuum_permeability * saturation_magnetization);
        number_density = saturation_magnetization / grain_moment;
      }
    return {saturation_magnetization, initial_susceptibility, number_density};
  }
} // namespace magmpm
