#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /**
   * Extremes over particles after a step, for the limits of the time step and to notice a run that
   * went astray. A value that is not a number counts as infinite.
   */
  struct ParticleExtremes
  {
    double speed                    = 0.; ///< |v| [m/s]
    double signal_speed             = 0.; ///< wave speed of the deformed material + |v| [m/s]
    double affine_velocity          = 0.; ///< Frobenius norm of C [1/s]
    double max_volume_ratio         = 0.; ///< J
    double max_inverse_volume_ratio = 0.; ///< 1/J; infinite where J <= 0

    template <typename F>
    void
    for_each_number(F &&f)
    {
      f(speed);
      f(signal_speed);
      f(affine_velocity);
      f(max_volume_ratio);
      f(max_inverse_volume_ratio);
    }
  };

  /**
   * P2G, Eq. (28) of Sun et al. 2021 in the form of MLS-MPM: mass and momentum with the affine part
   * of APIC, the impulse of the stress and of the carried magnetic force over a step,
   *   (m v)_i += N_ip [ m (v + dt a) + (m C - dt 4/dx^2 V_0 tau) (x_i - x_p) ].
   *
   * @param field  on return the sums over this rank's particles, also on ghosts.
   */
  template <int dim>
  void
  particles_to_lattice(std::vector<Body<dim>> &bodies,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       NodeField<dim> &field);

  /**
   * G2P and advection, Eqs. (35-37): velocity and affine velocity from the nodes, then deformation
   * and position over a step.
   *
   * @param field  velocities, ghosts up to date.
   * @return extremes over this rank's particles after the step, one per body.
   */
  template <int dim>
  std::vector<ParticleExtremes>
  lattice_to_particles(const NodeField<dim> &field,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       std::vector<Body<dim>> &bodies);
} // namespace magmpm
