#pragma once

#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/rigid_contact.h>
#include <magmpm/boundary/solid_contact.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /** The solids of a contact group on the lattice, and what SolidContact found of them. */
  template <int dim>
  struct CollidingGroup
  {
    const SolidContact<dim> &contact; ///< what it gave to bodies on the ranks, they get
    NodeField<dim> &field;            ///< {velocity [m/s], mass [kg]}
    NodeField<dim> &unconstrained;    ///< as of update_lattice_momentum()
  };

  /**
   * What free rigid bodies and solids on the lattice do to each other in a step, together with what bodies
   * and walls do to bodies: an inelastic impact, all of it at once.
   *
   * A node i that the surface of a body holds or rubs (SolidContact::touched_nodes()) leaves the impact with
   * v_i + D_i (u_i - v_i), where u_i is the velocity of the body at the node after it and D_i the part of the relative velocity that contact takes away
   * (contact_share()): I for stick, n n^T for slip, nothing where separate lets go, and of the
   * tangential part as much as Coulomb's law allows. The body gets the opposite impulse, so that its
   * motion V after the impact solves
   *   (A_0 + sum_i m_i B_i^T D_i B_i) V = b_0 + sum_i m_i B_i^T D_i v_i + impulses of other contacts,
   *   u_i = B_i V,
   * with A_0, b_0 mass, inertia and momenta of the body alone. The D_i depend on V: found by
   * iteration, for separate Newton's method for a convex function. Momentum and angular momentum of
   * bodies and nodes are conserved to rounding whatever the D_i are, energy never grows, and nothing
   * limits the ratio of the masses.
   *
   * Of what SolidContact pressed on, bodies get the impulses, another b_0. Fluids: see FluidContact.
   */
  template <int dim>
  class RigidCollision
  {
  public:
    /**
     * @param spacing_of_points  between points of the bodies' surfaces where they touch walls and each
     *                           other [m].
     */
    RigidCollision(const Lattice<dim> &lattice,
                   const WallParameters<dim> &walls,
                   const std::vector<RigidBody<dim>> &bodies,
                   const double spacing_of_points);

    /**
     * Changes the motion of free bodies and the velocity of the owned nodes that these touch. Nothing
     * happens without free bodies. Collective.
     *
     * @param bodies        those that were given to the constructor, the same on all ranks.
     * @param boundary      has the last word on the nodes.
     * @return iterations that it took.
     */
    int
    collide(const BlockSet<dim> &blocks,
            const LatticeBoundary<dim> &boundary,
            const double time_step,
            const MPI_Comm communicator,
            const std::vector<CollidingGroup<dim>> &groups,
            std::vector<RigidBody<dim>> &bodies) const;

  private:
    const Lattice<dim> lattice;
    const RigidContactSearch<dim> search;
  };
} // namespace magmpm
