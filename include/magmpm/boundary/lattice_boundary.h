#pragma once

#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/magnets/external_field.h>

#include <vector>

namespace magmpm
{
  /**
   * What walls and solid magnets do to the velocity of a lattice node, Eq. (34): a condition on the
   * node, not on the particle. Walls act on nodes on or beyond the faces of the mechanical box,
   * magnets on nodes inside their surface, relative to their own motion.
   *
   * stick: the node moves with the surface; slip: not through it; separate: not into it.
   */
  template <int dim>
  class LatticeBoundary
  {
  public:
    /** @param sources  their solid magnets are colliders, where they are at the moment of a call. */
    LatticeBoundary(const Lattice<dim> &lattice,
                    const WallParameters<dim> &walls,
                    const ExternalField<dim> &sources);

    /** The velocity [m/s] that the boundaries leave to a node. */
    Vector<dim>
    constrained(const Index<dim> &node, Vector<dim> velocity) const;

    /** The speed of the fastest collider [m/s], which limits the time step as that of particles does. */
    double
    max_speed() const;

  private:
    const Lattice<dim> lattice;
    const WallParameters<dim> walls;
    const ExternalField<dim> &sources;
  };
} // namespace magmpm
