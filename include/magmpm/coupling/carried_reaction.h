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
    /** Takes what a solve found. @param way  since the solve for which this was called before, or 0 [m]. */
    void
    set(const std::vector<ForceAndTorque<dim>> &found, const double way);

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
    }

  private:
    std::vector<ForceAndTorque<dim>> now;  ///< by source
    std::vector<ForceAndTorque<dim>> rate; ///< per way of the fastest particle [.../m]
    double advanced = 0.;                  ///< since they were found [m]
  };
} // namespace magmpm
