#pragma once

#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/solid_contact.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>

namespace magmpm
{
  /** What a node of less mass could give to a particle is below rounding [kg]. */
  inline double
  negligible_mass(const double typical_mass)
  {
    return 1e-12 * typical_mass;
  }

  /**
   * Momentum to velocity on the owned nodes, Eqs. (33), (34): v_i = (m v)_i/m_i + dt g, times
   * exp(-rate dt) where there is damping, then the boundaries. The impulses of stress and magnetic force are
   * in the momentum already. A node whose mass is below 1e-12 of @p typical_mass is left at rest: what it
   * could give to a particle is below rounding.
   *
   * @param boundary       of nodes that are not those of @p contact.
   * @param contact        of solids; its sums are those of this step, or it has none.
   * @param damping_rate   dv/dt = -rate v [1/s].
   * @param field          its momentum becomes velocity.
   * @param unconstrained  on return the velocities without what holds nodes, but with the pressure of contact, a
   *                       force; without blocks: not wanted.
   */
  template <int dim>
  void
  update_lattice_momentum(const BlockSet<dim> &blocks,
                          const LatticeBoundary<dim> &boundary,
                          SolidContact<dim> &contact,
                          const Vector<dim> &gravity,
                          const double time_step,
                          const double damping_rate,
                          const double typical_mass,
                          NodeField<dim> &field,
                          NodeField<dim> &unconstrained);

  /**
   * P v on the owned nodes from its momenta, with the masses of @p motion. Where a boundary has changed the
   * velocity along an axis (motion and @p unconstrained differ) P v is v along it: what is held there is no error
   * of the transfer.
   *
   * @param filtered  its momentum, of filter_velocity(), becomes velocity.
   */
  template <int dim>
  void
  update_filtered_velocity(const BlockSet<dim> &blocks,
                           const double typical_mass,
                           const NodeField<dim> &motion,
                           const NodeField<dim> &unconstrained,
                           NodeField<dim> &filtered);

  /**
   * v + alpha (v - P v) on all nodes, ghosts too, with the same alpha for all particles.
   *
   * @param motion, filtered  v and P v, ghosts up to date.
   */
  template <int dim>
  void
  give_back(const BlockSet<dim> &blocks,
            const double share,
            const NodeField<dim> &motion,
            const NodeField<dim> &filtered,
            NodeField<dim> &taken);

  /**
   * The same on the owned nodes, where particles differ in alpha: v + (sum_p alpha_p m_p N_ip v - B)/m,
   * which leaves the momentum as it is.
   *
   * @param taken  the sums of filter_velocity() with the factors alpha, the momentum B and the mass; becomes
   *               the velocity.
   */
  template <int dim>
  void
  give_back_by_particle(const BlockSet<dim> &blocks,
                        const double typical_mass,
                        const NodeField<dim> &motion,
                        const NodeField<dim> &unconstrained,
                        NodeField<dim> &taken);
} // namespace magmpm
