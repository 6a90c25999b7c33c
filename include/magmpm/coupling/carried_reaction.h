#pragma once

#include <magmpm/magnets/source_field.h>
#include <magmpm/simulation/run_state.h>

#include <vector>

namespace magmpm
{
  /**
   * The force and torque of the material on magnets between two solves: like the force that particles
   * carry (coupling/carried_force.h) they go on changing at the rate of the last two solves, per way
   * of the fastest particle, and no faster than by half of themselves over a way as long as the last.
   */

  /** Takes what a solve found. @param way  since the last solve for which this was called, or 0 [m]. */
  template <int dim>
  void
  set_reactions(std::vector<ForceAndTorque<dim>> found,
                const double way,
                CarriedReactions &reactions);

  /** @param way  [m] */
  void
  advance_reactions(const double way, CarriedReactions &reactions);

  /** Goes back to what was found at the last solve, @p way [m] ago, and stays there. */
  void
  hold_reactions(const double way, CarriedReactions &reactions);

  /** On one source; zero before anything was found. */
  template <int dim>
  ForceAndTorque<dim>
  reaction_on(const std::size_t source, const CarriedReactions &reactions);
} // namespace magmpm
