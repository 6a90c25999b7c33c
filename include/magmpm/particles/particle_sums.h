#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

namespace magmpm
{
  /**
   * Sums and extremes over the particles of a body; those of ranks and bodies can be combined. In
   * 2D everything is per metre of depth.
   *
   * @tparam Number  double; Simd while many particles are summed at once.
   */
  template <int dim, typename Number = double>
  struct ParticleSums
  {
    Number n_particles          = 0.;
    Number mass                 = 0.;        ///< [kg]
    Number kinetic_energy       = 0.;        ///< sum of m |v|^2/2 [J]
    Number elastic_energy       = 0.;        ///< sum of V_0 psi [J]; see smoothed_volume.h
    Number gravitational_energy = 0.;        ///< -sum of m g.x [J]
    Vector<dim, Number> momentum;            ///< [kg m/s]
    Vector<dim, Number> mass_times_position; ///< [kg m]

    /** About the origin, with the part of the affine velocities: m dx^2/4 times their curl [J s]. */
    Vector<n_axial_components<dim>, Number> angular_momentum;

    Vector<dim, Number> magnetic_force;  ///< sum of m a, carried since the last solve [N]
    Vector<dim, Number> magnetic_moment; ///< sum of J V_0 M, M from H at the last solve [A m^2]

    Number max_speed           = 0.; ///< [m/s]
    Number max_affine_velocity = 0.; ///< Frobenius norm of C [1/s]
    Number min_volume_ratio    = 1e300;
    Number max_volume_ratio    = 0.;
    Number max_field           = 0.; ///< |H| [A/m]
    Number max_magnetization   = 0.; ///< |M| [A/m]

    /** The force of magnets on a particle over its mass, at most [m/s^2]. */
    Number max_magnetic_acceleration = 0.;
    /** sqrt(mu_0 |M|^2/rho), the speed of the waves that magnetization adds, at most [m/s]. */
    Number max_magnetic_wave_speed = 0.;

    /** Takes other particles in. */
    ParticleSums &
    operator+=(const ParticleSums &other);

    /**
     * Calls visitor.sum(), .max() or .min() with each member, by how it is combined with that of other
     * particles; so a parallel::Reduction combines the sums of ranks.
     *
     * @param others  sums whose same members are handed over beside it.
     */
    template <typename Visitor, typename... Sums>
    void
    for_each_member(Visitor &visitor, const Sums &...others)
    {
      visitor.sum(n_particles, others.n_particles...);
      visitor.sum(mass, others.mass...);
      visitor.sum(kinetic_energy, others.kinetic_energy...);
      visitor.sum(elastic_energy, others.elastic_energy...);
      visitor.sum(gravitational_energy, others.gravitational_energy...);
      visitor.sum(momentum, others.momentum...);
      visitor.sum(mass_times_position, others.mass_times_position...);
      visitor.sum(angular_momentum, others.angular_momentum...);
      visitor.sum(magnetic_force, others.magnetic_force...);
      visitor.sum(magnetic_moment, others.magnetic_moment...);
      visitor.max(max_speed, others.max_speed...);
      visitor.max(max_affine_velocity, others.max_affine_velocity...);
      visitor.min(min_volume_ratio, others.min_volume_ratio...);
      visitor.max(max_volume_ratio, others.max_volume_ratio...);
      visitor.max(max_field, others.max_field...);
      visitor.max(max_magnetization, others.max_magnetization...);
      visitor.max(max_magnetic_acceleration, others.max_magnetic_acceleration...);
      visitor.max(max_magnetic_wave_speed, others.max_magnetic_wave_speed...);
    }
  };

  template <int dim>
  ParticleSums<dim>
  particle_sums(const Body<dim> &body,
                const Lattice<dim> &lattice,
                const Vector<dim> &gravity,
                const MagnetizationModel &law);

  /** Keeps the positions of a magnetic body's particles, for way_since_solve(). */
  template <int dim>
  void
  remember_positions(Body<dim> &body);

  /** How far a particle of a magnetic body is from where it was remembered, at most [m]. */
  template <int dim>
  double
  way_since_solve(const Body<dim> &body);
} // namespace magmpm
