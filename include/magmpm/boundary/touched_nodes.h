#pragma once

#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/rigid_contact.h>
#include <magmpm/boundary/solid_contact.h>
#include <magmpm/boundary/surface_contact.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>

#include <vector>

namespace magmpm
{
  /** The owned nodes of solids that touch free bodies, and what these do to them beyond SolidContact. */
  template <int dim>
  class TouchedNodes
  {
  public:
    /** Those that @p contact says are touched. */
    TouchedNodes(const std::vector<RigidBody<dim>> &bodies,
                 const SolidContact<dim> &contact,
                 const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 const NodeField<dim> &field);

    /** Decides what contact takes away at each node, if the bodies move with @p motions. */
    void
    update_shares(const std::vector<RigidBody<dim>> &bodies,
                  const std::vector<RigidVector<dim>> &motions);

    /** Adds the nodes' part of the equations of the bodies. */
    void
    add_to(std::vector<RigidEquation<dim>> &equations) const;

    /**
     * Gives the nodes the velocities that contact leaves them; then @p boundary has its say.
     *
     * @param unconstrained  gets them as well, before the boundary: the impulses of free bodies are forces, and
     *                       nothing holds these nodes; without blocks: not wanted.
     */
    void
    apply(const std::vector<RigidVector<dim>> &motions,
          const BlockSet<dim> &blocks,
          const LatticeBoundary<dim> &boundary,
          NodeField<dim> &field,
          NodeField<dim> &unconstrained) const;

  private:
    struct Node
    {
      int slot, number; ///< in the field
      int body;
      Vector<dim> from_centre; ///< of the body [m]
      Vector<dim> normal;      ///< out of the body
      Vector<dim> velocity;    ///< before the impact [m/s]
      double mass;             ///< [kg]
      ContactShare share;
      bool is_held    = false; ///< may not leave
      double pressing = 0.;    ///< normal impulse that it got already [N s]
    };

    std::vector<Node> nodes;
  };
} // namespace magmpm
