#pragma once

#include <magmpm/particles/body.h>

namespace magmpm
{
  /** The law of a material. @param density  undeformed [kg/m^3]. */
  template <int dim>
  Material<dim>
  make_material(const MaterialParameters &parameters, const double density);

  /** Speed of the fastest wave in undeformed material [m/s]. */
  template <int dim>
  inline double
  undeformed_wave_speed(const Material<dim> &material)
  {
    return std::visit([](const auto &law) { return law.wave_speed(law.undeformed()); }, material);
  }

  /** NeoHookean::smoothed_modulus(), zero of a fluid [Pa]. */
  template <int dim>
  inline double
  smoothed_modulus(const Material<dim> &material)
  {
    const auto *solid = std::get_if<NeoHookean<dim>>(&material);
    return solid != nullptr ? solid->smoothed_modulus() : 0.;
  }
} // namespace magmpm
