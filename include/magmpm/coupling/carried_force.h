#pragma once

#include <magmpm/particles/body.h>

namespace magmpm
{
  /**
   * Between solves of the potential magnetic particles carry the force as an acceleration a, which goes
   * on changing at the rate of the last two solves, da/ds = (a_now - a_before)/way: to second order the
   * force follows the motion, where a constant one would lag behind. s is a way, that of the material
   * and the sources: a force depends on places, so this holds too where the speed changes.
   *
   * Over a way as long as the last one a changes by at most half of itself, so that an impact, or a
   * magnet switched on, is not carried on.
   */

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
  hold_carried_force(const double way, Body<dim> &body);

  /** @param way  in a step [m]. */
  template <int dim>
  void
  advance_carried_force(const double way, Body<dim> &body);

  /** Makes an end of it: particles carry no magnetic force and know no field. */
  template <int dim>
  void
  drop_carried_force(Body<dim> &body);
} // namespace magmpm
