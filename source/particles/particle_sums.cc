#include <magmpm/base/constants.h>
#include <magmpm/particles/particle_quantities.h>
#include <magmpm/particles/particle_state.h>
#include <magmpm/particles/particle_sums.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Twice the axial vector of the skew part: the curl of v = C x. */
    template <int dim, typename Number>
    Vector<n_axial_components<dim>, Number>
    curl(const Matrix<dim, Number> &c)
    {
      if constexpr (dim == 3)
        return {{c(2, 1) - c(1, 2), c(0, 2) - c(2, 0), c(1, 0) - c(0, 1)}};
      else
        return {{c(1, 0) - c(0, 1)}};
    }

    template <typename Number>
    void
    raise(Number &largest, const Number &value)
    {
      using std::max;
      largest = max(largest, value);
    }

    template <typename Number>
    void
    lower(Number &smallest, const Number &value)
    {
      using std::max;
      smallest = -max(-smallest, -value);
    }

    /** What the sums need beside the particles. */
    template <int dim>
    struct Setting
    {
      double affine_factor; ///< dx^2/4 [m^2]
      Vector<dim> gravity;
      MagneticParameters magnetic;
      MagnetizationModel magnetization_law;
    };

    /** Adds the magnetics of the particles at @p place; extremes of speeds and fields are squares. */
    template <int dim, typename Place, typename Number>
    void
    add_magnetics(const ParticleArrays<dim, const double> &particles,
                  const Setting<dim> &setting,
                  const Number volume_ratio,
                  const Place place,
                  ParticleSums<dim, Number> &sums)
    {
      const Number mass       = load(particles.mass, place);
      const Number volume     = volume_ratio * load(particles.volume, place);
      const auto acceleration = load_vector<dim>(particles.magnetic_acceleration, place);
      const auto field        = load_vector<dim>(particles.magnetic_field, place);
      const auto magnetization =
        diluted_magnetization(setting.magnetic, setting.magnetization_law, volume_ratio, field);
      const Number square = norm_square(magnetization);
      sums.magnetic_force += mass * acceleration;
      sums.magnetic_moment += volume * magnetization;
      raise(sums.max_field, norm_square(field));
      raise(sums.max_magnetization, square);
      raise(sums.max_magnetic_acceleration, norm_square(acceleration));
      raise(sums.max_magnetic_wave_speed, constants::vacuum_permeability * square * volume / mass);
    }

    /** Adds what the particles at @p place are and do; extremes of speeds and fields are squares. */
    template <int dim, typename Law, typename Place, typename Number>
    void
    add_particles(const ParticleArrays<dim, const double> &particles,
                  const Law &law,
                  const Setting<dim> &setting,
                  const Place place,
                  ParticleSums<dim, Number> &sums)
    {
      const auto state          = load_state<dim, Law>(particles, place);
      const Number volume_ratio = law.volume_ratio(state);
      const Number mass         = load(particles.mass, place);
      const auto position       = load_vector<dim>(particles.position, place);
      const auto velocity       = load_vector<dim>(particles.velocity, place);
      const Number square       = norm_square(velocity);
      sums.n_particles += 1.;
      sums.mass += mass;
      sums.kinetic_energy += 0.5 * mass * square;
      sums.elastic_energy += load(particles.volume, place) * law.energy_density(state);
      for (int d = 0; d < dim; ++d)
        sums.gravitational_energy -= mass * (setting.gravity[d] * position[d]);
      sums.momentum += mass * velocity;
      sums.mass_times_position += mass * position;
      sums.angular_momentum += mass * cross(position, velocity);
      const auto affine = load_matrix<dim>(particles.affine_velocity, place);
      sums.angular_momentum += (setting.affine_factor * mass) * curl(affine);
      raise(sums.max_speed, square);
      raise(sums.max_affine_velocity, frobenius_norm(affine));
      lower(sums.min_volume_ratio, volume_ratio);
      raise(sums.max_volume_ratio, volume_ratio);
      if (setting.magnetic.is_magnetic())
        add_magnetics(particles, setting, volume_ratio, place, sums);
    }

    /**
     * What smoothed_volume.h makes of the elastic energy [J]: sum of V_0/2 ln J times what the volumetric
     * stress differs from lambda ln J.
     */
    template <int dim, typename Law>
    double
    energy_of_smoothing(const ParticleArrays<dim, const double> &particles,
                        const std::size_t n_particles,
                        const Law &law)
    {
      double energy = 0.;
      if constexpr (Law::stores_deformation_gradient)
        if (particles.volumetric_stress != nullptr)
          for (std::size_t p = 0; p < n_particles; ++p)
            {
              const double strain = std::log(law.volume_ratio(load_state<dim, Law>(particles, p)));
              energy += 0.5 * particles.volume[p] * strain *
                        (particles.volumetric_stress[p] - law.lame_lambda * strain);
            }
      return energy;
    }

    /** Takes the members of one lane. */
    struct LaneTaker
    {
      const std::size_t lane;

      void
      sum(double &to, const SimdDouble &from) const
      {
        to = from[lane];
      }

      template <int n>
      void
      sum(Vector<n> &to, const Vector<n, SimdDouble> &from) const
      {
        for (int i = 0; i < n; ++i)
          to[i] = from.values[i][lane];
      }

      void
      max(double &to, const SimdDouble &from) const
      {
        sum(to, from);
      }

      void
      min(double &to, const SimdDouble &from) const
      {
        sum(to, from);
      }
    };

    template <int dim>
    ParticleSums<dim>
    lane_of(const ParticleSums<dim, SimdDouble> &sums, const std::size_t lane)
    {
      ParticleSums<dim> result;
      const LaneTaker taker = {lane};
      result.for_each_member(taker, sums);
      return result;
    }

    /** Combines the members of two sets of particles. */
    struct Combiner
    {
      template <typename T>
      void
      sum(T &one, const T &other) const
      {
        one += other;
      }

      void
      max(double &one, const double other) const
      {
        one = std::max(one, other);
      }

      void
      min(double &one, const double other) const
      {
        one = std::min(one, other);
      }
    };

    /** Takes the roots of what was summed as squares. */
    template <int dim>
    void
    take_roots(ParticleSums<dim> &sums)
    {
      for (double *largest : {&sums.max_speed,
                              &sums.max_field,
                              &sums.max_magnetization,
                              &sums.max_magnetic_acceleration,
                              &sums.max_magnetic_wave_speed})
        *largest = std::sqrt(*largest);
    }
  } // namespace

  template <int dim, typename Number>
  ParticleSums<dim, Number> &
  ParticleSums<dim, Number>::operator+=(const ParticleSums &other)
  {
    const Combiner combiner;
    for_each_member(combiner, other);
    return *this;
  }

  template <int dim>
  ParticleSums<dim>
  particle_sums(const Body<dim> &body,
                const Lattice<dim> &lattice,
                const Vector<dim> &gravity,
                const MagnetizationModel &magnetization_law)
  {
    constexpr std::size_t width = SimdDouble::n_lanes;
    const auto particles        = body.particles.arrays();
    const std::size_t n         = body.particles.size();
    const Setting<dim> setting  = {
       0.25 * lattice.spacing * lattice.spacing, gravity, body.magnetic, magnetization_law};
    ParticleSums<dim> sums;
    std::visit(
      [&](const auto &law) {
        const auto law_of_lanes = law.template with_number<SimdDouble>();
        ParticleSums<dim, SimdDouble> sums_of_lanes;
        std::size_t p = 0;
        for (; p + width <= n; p += width)
          add_particles(particles, law_of_lanes, setting, FullLanes{p}, sums_of_lanes);
        for (std::size_t lane = 0; lane < width; ++lane)
          sums += lane_of(sums_of_lanes, lane);
        for (; p < n; ++p)
          add_particles(particles, law, setting, p, sums);
        sums.elastic_energy += energy_of_smoothing<dim>(particles, n, law);
      },
      body.material);
    take_roots(sums);
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

#define INSTANTIATE(dim)                                                                       \
  template struct ParticleSums<dim>;                                                           \
  template ParticleSums<dim> particle_sums(                                                    \
    const Body<dim> &, const Lattice<dim> &, const Vector<dim> &, const MagnetizationModel &); \
  template void remember_positions(Body<dim> &);                                               \
  template double way_since_solve(const Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
