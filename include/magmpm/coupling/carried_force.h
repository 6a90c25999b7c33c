#pragma once

#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /**
   * Between solves of the potential magnetic particles carry the force as an acceleration and its gradient,
   * which go on changing at the rate of the last two solves (coupling/extrapolation.h).
   */

  /**
   * Lets magnetic particles take the accelerations a_i = f_i/m_i of the nodes as G2P takes velocities, with
   * an affine part,
   *   a_p = sum_i N_ip a_i,   A_p = 4/dx^2 sum_i N_ip a_i (x_i - x_p)^T,
   * which P2G gives back to the nodes around. a_p alone would lay the force of a surface half a dx too deep.
   * With A_p, sum and first moments are kept, exactly and particle by particle: force, torque and virial are
   * those of the f_i, and f_i stays where it acts but for its second moments. Collective.
   *
   * @param masses  of magnetic particles on the nodes [kg].
   * @param force   [N] on owned nodes, zero where no mass is.
   */
  template <int dim>
  void
  carry_force(const BlockPartition<dim> &partition,
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
