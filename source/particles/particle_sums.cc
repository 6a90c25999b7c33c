#include <magmpm/base/constants.h>
#include <magmpm/particles/particle_state.h>
#include <magmpm/particles/particle_sums.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
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

    /** M of grains that are spread over @p volume_ratio times their undeformed volume. */
    template <int dim>
    Vector<dim>
    diluted_magnetization(const MagneticParameters &magnetic,
                          const MagnetizationLaw law,
                          const double volume_ratio,
                          const Vector<dim> &field)
    {
      return magnetization(law,
                           MagneticContent{magnetic.saturation_magnetization / volume_ratio,
                                           magnetic.initial_susceptibility / volume_ratio},
                           field);
    }

    template <int dim>
    void
    add_magnetics(const ParticleArrays<dim, const double> &particles,
                  const MagneticParameters &magnetic,
                  const MagnetizationLaw law,
                  const double volume_ratio,
                  const std::size_t p,
                  ParticleSums<dim> &sums)
    {
      const double mass               = particles.mass[p];
      const double volume             = volume_ratio * particles.volume[p];
      const Vector<dim> acceleration  = load_vector<dim>(particles.magnetic_acceleration, p);
      const Vector<dim> field         = load_vector<dim>(particles.magnetic_field, p);
      const Vector<dim> magnetization = diluted_magnetization(magnetic, law, volume_ratio, field);
      const double strength           = norm(magnetization);
      sums.magnetic_force += mass * acceleration;
      sums.magnetic_moment += volume * magnetization;
      sums.max_field                 = std::max(sums.max_field, norm(field));
      sums.max_magnetization         = std::max(sums.max_magnetization, strength);
      sums.max_magnetic_acceleration = std::max(sums.max_magnetic_acceleration, norm(acceleration));
      sums.max_magnetic_wave_speed =
        std::max(sums.max_magnetic_wave_speed,
                 strength * std::sqrt(constants::vacuum_permeability * volume / mass));
    }

    /** Adds what one particle is and does. */
    template <int dim, typename Law>
    void
    add_mechanics(const ParticleArrays<dim, const double> &particles,
                  const Law &law,
                  const typename Law::State &state,
                  const double volume_ratio,
                  const double affine_factor,
                  const Vector<dim> &gravity,
                  const std::size_t p,
                  ParticleSums<dim> &sums)
    {
      const double mass          = particles.mass[p];
      const Vector<dim> position = load_vector<dim>(particles.position, p);
      const Vector<dim> velocity = load_vector<dim>(particles.velocity, p);
      const double square        = norm_square(velocity);
      sums.n_particles += 1.;
      sums.mass += mass;
      sums.kinetic_energy += 0.5 * mass * square;
      sums.elastic_energy += particles.volume[p] * law.energy_density(state);
      sums.gravitational_energy -= mass * dot(gravity, position);
      sums.momentum += mass * velocity;
      sums.mass_times_position += mass * position;
      sums.angular_momentum += mass * cross(position, velocity);
      const Matrix<dim> affine = load_matrix<dim>(particles.affine_velocity, p);
      sums.angular_momentum += (mass * affine_factor) * curl(affine);
      sums.max_speed           = std::max(sums.max_speed, std::sqrt(square));
      sums.max_affine_velocity = std::max(sums.max_affine_velocity, frobenius_norm(affine));
      sums.min_volume_ratio    = std::min(sums.min_volume_ratio, volume_ratio);
      sums.max_volume_ratio    = std::max(sums.max_volume_ratio, volume_ratio);
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
    max_affine_velocity       = std::max(max_affine_velocity, other.max_affine_velocity);
    min_volume_ratio          = std::min(min_volume_ratio, other.min_volume_ratio);
    max_volume_ratio          = std::max(max_volume_ratio, other.max_volume_ratio);
    max_field                 = std::max(max_field, other.max_field);
    max_magnetization         = std::max(max_magnetization, other.max_magnetization);
    max_magnetic_acceleration = std::max(max_magnetic_acceleration,
                                         other.max_magnetic_acceleration);
    max_magnetic_wave_speed   = std::max(max_magnetic_wave_speed, other.max_magnetic_wave_speed);
    return *this;
  }

  template <int dim>
  double
  particle_volume_ratio(const Body<dim> &body, const std::size_t p)
  {
    return std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        return law.volume_ratio(load_state<dim, Law>(body.particles.arrays(), p));
      },
      body.material);
  }

  template <int dim>
  double
  particle_von_mises_stress(const Body<dim> &body, const std::size_t p)
  {
    const auto particles = body.particles.arrays();
    return std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        return law.von_mises_stress(load_state<dim, Law>(particles, p),
                                    load_matrix<dim>(particles.affine_velocity, p));
      },
      body.material);
  }

  template <int dim>
  Vector<dim>
  particle_magnetization(const Body<dim> &body, const MagnetizationLaw law, const std::size_t p)
  {
    if (!body.magnetic.is_magnetic())
      return {};
    return diluted_magnetization(body.magnetic,
                                 law,
                                 particle_volume_ratio(body, p),
                                 body.particles.vector(ParticleProperty::magnetic_field, p));
  }

  template <int dim>
  ParticleSums<dim>
  particle_sums(const Body<dim> &body,
                const Lattice<dim> &lattice,
                const Vector<dim> &gravity,
                const MagnetizationLaw magnetization_law)
  {
    const auto particles       = body.particles.arrays();
    const double affine_factor = 0.25 * lattice.spacing * lattice.spacing;
    ParticleSums<dim> sums;
    std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        for (std::size_t p = 0; p < body.particles.size(); ++p)
          {
            const typename Law::State state = load_state<dim, Law>(particles, p);
            const double volume_ratio       = law.volume_ratio(state);
            add_mechanics(particles, law, state, volume_ratio, affine_factor, gravity, p, sums);
            if (body.magnetic.is_magnetic())
              add_magnetics(particles, body.magnetic, magnetization_law, volume_ratio, p, sums);
          }
      },
      body.material);
    return sums;
  }

  template <int dim>
  void
  remember_positions(Body<dim> &body)
  {
    if (body.magnetic.is_magnetic())
      for (int d = 0; d < dim; ++d)
        std::copy_n(body.particles.component(ParticleProperty::position, d),
                    body.particles.size(),
                    body.particles.component(ParticleProperty::position_at_solve, d));
  }

  template <int dim>
  double
  way_since_solve(const Body<dim> &body)
  {
    double longest_square = 0.;
    if (body.magnetic.is_magnetic())
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        longest_square =
          std::max(longest_square,
                   norm_square(body.particles.position(p) -
                               body.particles.vector(ParticleProperty::position_at_solve, p)));
    return std::sqrt(longest_square);
  }

#define INSTANTIATE(dim)                                                                         \
  template struct ParticleSums<dim>;                                                             \
  template ParticleSums<dim> particle_sums(                                                      \
    const Body<dim> &, const Lattice<dim> &, const Vector<dim> &, MagnetizationLaw);             \
  template Vector<dim> particle_magnetization(const Body<dim> &, MagnetizationLaw, std::size_t); \
  template void remember_positions(Body<dim> &);                                                 \
  template double way_since_solve(const Body<dim> &);                                            \
  template double particle_volume_ratio(const Body<dim> &, std::size_t);                         \
  template double particle_von_mises_stress(const Body<dim> &, std::size_t);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
