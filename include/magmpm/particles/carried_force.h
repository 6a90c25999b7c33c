#pragma once

#include <magmpm/particles/body.h>

namespace magmpm
{
  /**
   * Between solves of the potential magnetic particles carry the force as an acceleration a, which goes
   * on changing at the rate of the last two solves, da/dt = (a_now - a_before)/elapsed: to second order
   * the force follows the motion, where a constant one would lag behind. G2P advances a over each step.
   *
   * The change over a time as long as the last one is at most half of a, so that an impact, or a
   * magnet switched on, is not carried on.
   */

  /**
   * Before a solve: the rate becomes the acceleration at the solve before, until
   * set_rate_of_carried_force() makes a rate of it again.
   *
   * @param elapsed  since that solve [s].
   */
  template <int dim>
  void
  recall_carried_force(const double elapsed, Body<dim> &body);

  /** After the solve, with the new accelerations in place. @param elapsed  as before; 0: rate 0. */
  template <int dim>
  void
  set_rate_of_carried_force(const double elapsed, Body<dim> &body);
} // namespace magmpm
