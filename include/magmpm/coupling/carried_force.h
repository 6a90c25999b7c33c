#pragma once

#include <magmpm/particles/body.h>

namespace magmpm
{
  /**
   * Between solves of the potential magnetic particles carry the force as an acceleration, which goes on
   * changing at the rate of the last two solves (coupling/extrapolation.h).
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
  freeze_carried_force(const double way, Body<dim> &body);

  /** @param way  in a step [m]. */
  template <int dim>
  void
  advance_carried_force(const double way, Body<dim> &body);

  /** Makes an end of it: particles carry no magnetic force and know no field. */
  template <int dim>
  void
  drop_carried_force(Body<dim> &body);
} // namespace magmpm
