#include <magmpm/base/constants.h>
#include <magmpm/particles/particle_sums.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    template <int dim>
    Matrix<dim>
    affine_velocity(const ParticleSet<dim> &particles, const std::size_t p)
    {
      Matrix<dim> affine;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          affine(i, j) = particles.component(ParticleProperty::affine_velocity, dim * i + j)[p];
      return affine;
    }

    template <int dim, typename Law>
    typename Law::State
    state(const Law &, const ParticleSet<dim> &particles, const std::size_t p)
    {
      typename Law::State state = Law::undeformed();
      if constexpr (Law::stores_deformation_gradient)
        {
          for (int i = 0; i < dim; ++i)
            for (int j = 0; j < dim; ++j)
              state(i, j) = particles.component(ParticleProperty::deformation, dim * i + j)[p];
        }
      else
        state = particles.component(ParticleProperty::deformation, 0)[p];
      return state;
    }

    /** Twice the axial vector of the skew part: the curl of v = C x. */
    template <int dim>
    Vector<n_axial_components<dim>>
    curl(const Matrix<dim> &c)
    {
      if constexpr (dim == 3)
        return {{c(2, 1) - c(1, 2), c(0, 2) - c(2, 0), c(1, 0) - c(0, 1)}};
      else
        return {{c(1, 0) - c(0, 1)}};
    }

    template <int dim>
    void
    add_magnetics(const Body<dim>       &body,
                  const MagnetizationLaw law,
                  const std::size_t      p,
                  const double           volume_ratio,
                  ParticleSums<dim>     &sums)
    {
      const ParticleSet<dim> &particles    = body.particles;
      const double            mass         = particles.component(ParticleProperty::mass, 0)[p];
      const double            volume       = volume_ratio * particles.component(ParticleProperty::volume, 0)[p];
      const Vector<dim>       acceleration = particles.vector(ParticleProperty::magnetic_acceleration, p);
      const Vector<dim>       magnetization = particle_magnetization(body, law, p);
      const double            strength      = norm(magnetization);
      sums.magnetic_force += mass * acceleration;
      sums.magnetic_moment += volume * magnetization;
      sums.max_field = std::max(sums.max_field, norm(particles.vector(ParticleProperty::magnetic_field, p)));
      sums.max_magnetization         = std::max(sums.max_magnetization, strength);
      sums.max_magnetic_acceleration = std::max(sums.max_magnetic_acceleration, norm(acceleration));
      sums.max_magnetic_wave_speed =
        std::max(sums.max_magnetic_wave_speed,
                 strength * std::sqrt(constants::vacuum_permeability * volume / mass));
    }
  } // namespace

  template <int dim>
  ParticleSums<dim> &
  ParticleSums<dim>::operator+=(const ParticleSums &other)
  {
    n_particles += other.n_particles;
    mass += other.mass;
    kinetic_energy += other.kinetic_energy;
    elastic_energy += other.elastic_energy;
    gravitational_energy += other.gravitational_energy;
    momentum += other.momentum;
    mass_times_position += other.mass_times_position;
    angular_momentum += other.angular_momentum;
    magnetic_force += other.magnetic_force;
    magnetic_moment += other.magnetic_moment;
    max_speed                 = std::max(max_speed, other.max_speed);
    min_volume_ratio          = std::min(min_volume_ratio, other.min_volume_ratio);
    max_volume_ratio          = std::max(max_volume_ratio, other.max_volume_ratio);
    max_field                 = std::max(max_field, other.max_field);
    max_magnetization         = std::max(max_magnetization, other.max_magnetization);
    max_magnetic_acceleration = std::max(max_magnetic_acceleration, other.max_magnetic_acceleration);
    max_magnetic_wave_speed   = std::max(max_magnetic_wave_speed, other.max_magnetic_wave_speed);
    return *this;
  }

  template <int dim>
  double
  particle_volume_ratio(const Body<dim> &body, const std::size_t p)
  {
    return std::visit([&](const auto &law) { return law.volume_ratio(state(law, body.particles, p)); },
                      body.material);
  }

  template <int dim>
  double
  particle_von_mises_stress(const Body<dim> &body, const std::size_t p)
  {
    return std::visit(
      [&](const auto &law) {
        return law.von_mises_stress(state(law, body.particles, p),
                                    affine_velocity(body.particles, p));
      },
      body.material);
  }

  template <int dim>
  Vector<dim>
  particle_magnetization(const Body<dim> &body, const MagnetizationLaw law, const std::size_t p)
  {
    if (!body.magnetic.is_magnetic())
      return {};
    const double dilution = 1. / particle_volume_ratio(body, p);
    return magnetization(law,
                         MagneticContent{dilution * body.magnetic.saturation_magnetization,
                                         dilution * body.magnetic.initial_susceptibility},
                         body.particles.vector(ParticleProperty::magnetic_field, p));
  }

  template <int dim>
  ParticleSums<dim>
  particle_sums(const Body<dim>       &body,
                const Lattice<dim>    &lattice,
                const Vector<dim>     &gravity,
                const MagnetizationLaw law)
  {
    const ParticleSet<dim> &particles     = body.particles;
    const double           *masses        = particles.component(ParticleProperty::mass, 0);
    const double           *volumes       = particles.component(ParticleProperty::volume, 0);
    const double            affine_factor = 0.25 * lattice.spacing * lattice.spacing;
    ParticleSums<dim>       sums;
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const double      mass     = masses[p];
        const Vector<dim> position = particles.position(p);
        const Vector<dim> velocity = particles.vector(ParticleProperty::velocity, p);
        const double      square   = norm_square(velocity);
        sums.n_particles += 1.;
        sums.mass += mass;
        sums.kinetic_energy += 0.5 * mass * square;
        sums.gravitational_energy -= mass * dot(gravity, position);
        sums.momentum += mass * velocity;
        sums.mass_times_position += mass * position;
        sums.angular_momentum += mass * cross(position, velocity);
        sums.angular_momentum += (mass * affine_factor) * curl(affine_velocity(particles, p));
        sums.max_speed = std::max(sums.max_speed, std::sqrt(square));

        const auto [energy, volume_ratio] = std::visit(
          [&](const auto &material) {
            const auto deformation = state(material, particles, p);
            return std::make_pair(material.energy_density(deformation),
                                  material.volume_ratio(deformation));
          },
          body.material);
        sums.elastic_energy += volumes[p] * energy;
        sums.min_volume_ratio = std::min(sums.min_volume_ratio, volume_ratio);
        sums.max_volume_ratio = std::max(sums.max_volume_ratio, volume_ratio);
        if (body.magnetic.is_magnetic())
          add_magnetics(body, law, p, volume_ratio, sums);
      }
    return sums;
  }

#define INSTANTIATE(dim)                                                                           \
  template struct ParticleSums<dim>;                                                               \
  template ParticleSums<dim> particle_sums(const Body<dim> &, const Lattice<dim> &, const Vector<dim> &, MagnetizationLaw); \
  template Vector<dim> particle_magnetization(const Body<dim> &, MagnetizationLaw, std::size_t);   \
  template double particle_volume_ratio(const Body<dim> &, std::size_t);                           \
  template double particle_von_mises_stress(const Body<dim> &, std::size_t);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
