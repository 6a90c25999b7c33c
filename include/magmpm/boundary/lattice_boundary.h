#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/lattice.h>

#include <vector>

namespace magmpm
{
  /**
   * What walls and kinematic rigid bodies, such as solid magnets, do to the velocity of a lattice
   * node, Eq. (34): a condition on the node, not on the particle. Walls act on nodes on or beyond the
   * faces of the mechanical box, bodies on nodes inside their surface, relative to their own motion.
   * Free bodies are the business of RigidCollision.
   *
   * stick: the node moves with the surface; slip: not through it; separate: not into it; bodies with
   * friction along it (contact_share()).
   */
  template <int dim>
  class LatticeBoundary
  {
  public:
    /** @param bodies  where they are at the moment of a call. */
    LatticeBoundary(const Lattice<dim> &lattice,
                    const WallParameters<dim> &walls,
                    const std::vector<RigidBody<dim>> &bodies);

    /** The velocity [m/s] that the boundaries leave to a node. */
    Vector<dim>
    constrained(const Index<dim> &node, Vector<dim> velocity) const;

    /** The velocity that walls leave to a node of solids: those that let go or slip are a matter of SolidContact. */
    Vector<dim>
    at_sticking_walls(const Index<dim> &node, const Vector<dim> &velocity) const;

    /** The speed of the fastest rigid body [m/s], which limits the time step as that of particles does. */
    double
    max_speed() const;

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
    const std::vector<RigidBody<dim>> &bodies;
  };
} // namespace magmpm
