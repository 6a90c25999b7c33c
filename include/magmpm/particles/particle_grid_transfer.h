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
   *   (m v)_i += N_ip m [ v + dt a + C (x_i - x_p) ] - dt V_0 tau grad N_i(x_p),
   * a fluid's in the form of MLS-MPM, with 4/dx^2 N_ip (x_i - x_p) in place of grad N_i. That is no
   * gradient: a solid of which F grew by it would take up less strain than it is bent by, and creep.
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
   * The lattice's velocity once to the particles and back, as APIC takes it:
   *   (m P v)_i = sum_p m_p N_ip [ v_p + C_p (x_i - x_p) ],
   *   v_p = sum_i N_ip v_i,  C_p = 4/dx^2 sum_i N_ip v_i (x_i - x_p)^T.
   * P is symmetric in the product of the masses, with eigenvalues from 0 to 1; it keeps linear fields.
   * Nodes with next to no mass get v - P v of the order of dt a in every step, which the particles
   * never see.
   *
   * @param velocity  v, ghosts up to date.
   * @param filtered  the sums over this rank's particles are added to it, also on ghosts.
   */
  template <int dim>
  void
  filter_velocity(std::vector<Body<dim>> &bodies,
                  const BlockSet<dim> &blocks,
                  const Lattice<dim> &lattice,
                  const NodeField<dim> &velocity,
                  NodeField<dim> &filtered);

  /**
   * G2P and advection, Eqs. (35-37): velocity and affine velocity from the nodes, then deformation
   * and position over a step. What particles take, u, and what they move and deform with, w, is by
   * the transfer of their material
   *   apic:  u = w = v,
   *   fmpm:  u = v + alpha (v - P v),  w = P v,  alpha = exp(-2 dt c/dx),
   * with c the undeformed wave speed: FMPM(2) of Nairn and Hammerquist (Comput. Methods Appl. Mech. Engrg. 377, 113667, 2021), the loss of which counts
   * time, not steps. P v is all that particles and lattice agree about: what F would take up of the
   * rest, places would not. A solid deforms with the gradient of w, a fluid with C.
   *
   * @param velocity  v, ghosts up to date.
   * @param filtered  P v, likewise; without blocks if no body has the transfer fmpm.
   * @return extremes over this rank's particles after the step, one per body.
   */
  template <int dim>
  std::vector<ParticleExtremes>
  lattice_to_particles(const NodeField<dim> &velocity,
                       const NodeField<dim> &filtered,
                       const BlockSet<dim> &blocks,
                       const Lattice<dim> &lattice,
                       const double time_step,
                       std::vector<Body<dim>> &bodies);
} // namespace magmpm
