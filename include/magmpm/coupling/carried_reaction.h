#pragma once

#include <magmpm/coupling/section.h>
#include <magmpm/magnets/source_field.h>

#include <vector>

namespace magmpm
{
  template <typename Archive, int dim>
  void
  serialize(Archive &archive, ForceAndTorque<dim> &value, const unsigned int /*version*/)
  {
    archive &value.force;
    archive &value.torque;
  }

  /**
   * The force and torque of the material on magnets between two solves: like the force that particles
   * carry (coupling/carried_force.h) they go on changing at the rate of the last two solves, per way
   * of the fastest particle.
   */
  template <int dim>
  class CarriedReactions
  {
  public:
    /** There was a solve, @p way after the one before [m]; what it found is still to come, or never asked for. */
    void
    note_solve(const double way);

    /** Whether set() was called since then. */
    bool
    are_of_last_solve() const
    {
      return is_up_to_date;
    }

    /**
     * Takes what the last solve found.
     *
     * @param has_rate  whether they go on changing as they did since they were found before.
     */
    void
    set(const std::vector<ForceAndTorque<dim>> &found, const bool has_rate);

    /** @param way  [m] */
    void
    advance(const double way);

    /** Goes back to what was found last, and stays there. */
    void
    freeze();

    /** On one source; zero before anything was found. */
    ForceAndTorque<dim>
    on(const std::size_t source) const;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &now;
      archive &rate;
      archive &advanced;
      archive &way_since_set;
      archive &is_up_to_date;
    }

  private:
    std::vector<ForceAndTorque<dim>> now;  ///< by source
    std::vector<ForceAndTorque<dim>> rate; ///< per way of the fastest particle [.../m]
    double advanced      = 0.;             ///< since they were found [m]
    double way_since_set = 0.;   ///< to the last solve, from the one when they were found [m]
    bool is_up_to_date   = true; ///< are_of_last_solve()
  };
} // namespace magmpm
