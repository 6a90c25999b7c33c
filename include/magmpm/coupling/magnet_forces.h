#pragma once

#include <magmpm/coupling/carried_reaction.h>
#include <magmpm/magnets/external_field.h>

#include <vector>

namespace magmpm
{
  /** Force and torque on each source of the external field, by the material and by the other sources. */
  template <int dim>
  class MagnetForces
  {
  public:
    /** @param sources  must outlive this. */
    explicit MagnetForces(const ExternalField<dim> &sources);

    /**
     * By all that acts, in the order of the sources; the torques are about their positions. What other
     * sources do is evaluated when one of them has moved or changed since it was asked for last.
     */
    std::vector<ForceAndTorque<dim>>
    total(const CarriedReactions<dim> &reactions);

    /**
     * An upper bound of how fast a free magnet turns to and fro in the field of the others: the angular
     * frequency of a needle with @p inertia [kg m^2] in a field as large as that at its position [1/s].
     */
    double
    swing_rate(const std::size_t source, const double inertia) const;

  private:
    /** Whether all sources are what they were when by_sources was found; remembers them if not. */
    bool
    is_known();

    const ExternalField<dim> &sources;
    std::vector<unsigned long> known_revisions; ///< of the sources
    std::vector<ForceAndTorque<dim>> by_sources;
  };
} // namespace magmpm
