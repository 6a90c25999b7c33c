#pragma once

#include <magmpm/base/written_quantity.h>
#include <magmpm/particles/body.h>

namespace magmpm
{
  /** M of grains that are spread over @p volume_ratio times their undeformed volume. */
  template <int dim, typename Number>
  inline Vector<dim, Number>
  diluted_magnetization(const MagneticParameters &magnetic,
                        const MagnetizationModel &law,
                        const Number volume_ratio,
                        const Vector<dim, Number> &field)
  {
    return magnetization(law,
                         MagneticContentOf<Number>{magnetic.saturation_magnetization / volume_ratio,
                                                   magnetic.initial_susceptibility / volume_ratio},
                         field);
  }

  /** M [A/m] of a particle in the field H of the last solve: its grains in its present volume. */
  template <int dim>
  Vector<dim>
  particle_magnetization(const Body<dim> &body, const MagnetizationModel &law, const std::size_t p);

  /** J of a particle. */
  template <int dim>
  double
  particle_volume_ratio(const Body<dim> &body, const std::size_t p);

  /** Von Mises stress of a particle [Pa]. */
  template <int dim>
  double
  particle_von_mises_stress(const Body<dim> &body, const std::size_t p);

  /** A particle and all that its written quantities depend on. */
  template <int dim>
  struct WrittenParticle
  {
    const Body<dim> &body;
    const std::size_t number_of_body; ///< in the scene's list
    const MagnetizationModel &law;
    const std::size_t p; ///< in the body's particles
  };

  template <int dim>
  using ParticleQuantity = WrittenQuantity<dim, WrittenParticle<dim>>;

  /** What can be written of particles. */
  template <int dim>
  const std::vector<ParticleQuantity<dim>> &
  particle_quantities();
} // namespace magmpm
