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
   * P2G, Eq. (28) of Sun et al. 2021: mass, momentum with the affine part of APIC, and the impulses of
   * the stress and of the carried magnetic force over a step. A solid's stress acts by the gradient of
   * the lattice's own field,
   *   (m v)_i += N_ip m [ v + dt a + (C + dt A) (x_i - x_p) ] - dt V_0 tau grad N_i(x_p),
   * a fluid's in the form of MLS-MPM, with 4/dx^2 N_ip (x_i - x_p) in place of grad N_i. That is no
   * gradient: a solid of which F grew by it would take up less strain than it is bent by, and creep.
   * The stress of a nearly incompressible solid has the volumetric part that smoothed_volume.h found last.
   *
   * @param field  on return the sums over this rank's particles, also on ghosts.
   * @param group  the contact group whose particles count.
   */
  template <int dim>
  void
  particles_to_lattice(std::vector<Body<dim>> &bodies,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       NodeField<dim> &field,
                       const int group = every_group);

  /** The velocities of the lattice at the end of a step, ghosts up to date. */
  template <int dim>
  struct LatticeVelocities
  {
    const NodeField<dim> &velocity; ///< v
    const NodeField<dim> &filtered; ///< P v; without blocks, as the next, if all bodies have APIC
    const NodeField<dim> &taken;    ///< v and what FMPM gives back, v + alpha (v - P v)
  };

  /**
   * G2P and advection, Eqs. (35-37): velocity and affine velocity from the nodes, then deformation
   * and position over a step. Particles take v + alpha (v - P v), FMPM(2) of Nairn and Hammerquist (Comput.
   * Methods Appl. Mech. Engrg. 377, 113667, 2021). With FMPM they move and deform by P v, all that particles
   * and lattice agree about: what F would take up of the rest, places would not. With APIC a solid does
   * so by v, and a fluid by what it takes. A solid deforms with the gradient of the lattice's field, a fluid
   * with C.
   *
   * @param group  the contact group whose particles move.
   * @return extremes over this rank's particles after the step, one per body; zero for those of other groups.
   */
  template <int dim>
  std::vector<ParticleExtremes>
  lattice_to_particles(const LatticeVelocities<dim> &velocities,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       std::vector<Body<dim>> &bodies,
                       const int group = every_group);
} // namespace magmpm
