#pragma once

#include <magmpm/boundary/surface_contact.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/lattice.h>

namespace magmpm
{
  /**
   * What walls do to the velocity of a lattice node on or beyond the faces of the mechanical box, Eq. (34): a
   * condition on the node, not on the particle.
   *
   * stick: the node does not move; slip: not through the wall; separate: not into it; with friction along it
   * (contact_share()).
   */
  template <int dim>
  class LatticeBoundary
  {
  public:
    LatticeBoundary(const Lattice<dim> &lattice, const WallParameters<dim> &walls);

    /** The velocity [m/s] that walls leave to a node. */
    Vector<dim>
    constrained(const Index<dim> &node, Vector<dim> velocity) const;

    /** The velocity that walls leave to a node of solids: those that let go or slip are a matter of SolidContact. */
    Vector<dim>
    at_sticking_walls(const Index<dim> &node, const Vector<dim> &velocity) const;

  private:
    /** Whether a node lies on or beyond a face of the box. */
    bool
    is_at_wall(const Index<dim> &node, const int face) const
    {
      const int d = face / 2;
      return face % 2 == 0 ? node[d] <= 0 : node[d] >= lattice.n_cells[d];
    }

    const Lattice<dim> lattice;
    const WallParameters<dim> walls;
  };
} // namespace magmpm
