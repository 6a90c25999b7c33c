#pragma once

#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /**
   * Between solves of the potential magnetic particles carry the force as an acceleration, which goes on
   * changing at the rate of the last two solves (coupling/extrapolation.h).
   */

  /**
   * Accelerations of the nodes [m/s^2] for magnetic particles to take. With a_i = f_i/m_i what they give
   * back in P2G would be the force smeared once more, out of the layer that it acts on into what still
   * moves freely; so that is corrected by a step of Richardson's,
   *   a_i <- a_i + (f_i - sum_p m_p N_ip sum_j N_jp a_j)/m_i,
   * which leaves the sum of the force. Collective.
   *
   * @param masses  of magnetic particles on the nodes [kg].
   * @param force   [N] on owned nodes.
   * @return with ghosts up to date.
   */
  template <int dim>
  NodeField<dim, SingleVector>
  accelerations_to_carry(const BlockPartition<dim> &partition,
                         const Lattice<dim> &lattice,
                         const NodeField<dim, SingleScalar> &masses,
                         const NodeField<dim, SingleVector> &force,
                         std::vector<Body<dim>> &bodies);

  /**
   * Before a solve: the rate becomes the acceleration at the solve before, until
   * set_rate_of_carried_force() makes a rate of it again.
   *
   * @param way  s since that solve [m], what advance_carried_force() was given in all.
   */
  template <int dim>
  void
  recall_carried_force(const double way, Body<dim> &body);

  /** After the solve, with the new accelerations in place. @param way  as before; 0: rate 0. */
  template <int dim>
  void
  set_rate_of_carried_force(const double way, Body<dim> &body);

  /** Goes back to the acceleration of the last solve and keeps it. @param way  as for recall. */
  template <int dim>
  void
  freeze_carried_force(const double way, Body<dim> &body);

  /** @param way  in a step [m]. */
  template <int dim>
  void
  advance_carried_force(const double way, Body<dim> &body);

  /**
   * The work of the carried force since the solve, on the straight way from where particles were then:
   * sum of m (a_then + a_now)/2 . (x - x_then) over this rank's particles [J].
   *
   * @param way  as for recall.
   */
  template <int dim>
  double
  work_since_solve(const double way, const Body<dim> &body);

  /** Makes an end of it: particles carry no magnetic force and know no field. */
  template <int dim>
  void
  drop_carried_force(Body<dim> &body);
} // namespace magmpm
