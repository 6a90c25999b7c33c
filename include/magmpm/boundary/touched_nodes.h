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
  /** The owned lattice nodes with mass inside free bodies, and what contact does to them. */
  template <int dim>
  class TouchedNodes
  {
  public:
    /**
     * The nodes inside bodies, apart from those that @p contact acts on, and those that it says are touched.
     * Nodes with no more than @p negligible_mass [kg] do not count.
     */
    TouchedNodes(const std::vector<RigidBody<dim>> &bodies,
                 const SolidContact<dim> &contact,
                 const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 const double negligible_mass,
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
      bool is_solid   = false; ///< pressed as SolidContact says, not by its being inside
      bool is_held    = false; ///< of a solid: may not leave
      double pressing = 0.;    ///< of a solid: normal impulse that it got already [N s]
    };

    void
    add_solids(const std::vector<RigidBody<dim>> &bodies,
               const SolidContact<dim> &contact,
               const BlockSet<dim> &blocks,
               const Lattice<dim> &lattice,
               const NodeField<dim> &field);

    /** Adds @p node if it lies inside one of the bodies @p near. */
    void
    add_if_touched(const std::vector<RigidBody<dim>> &bodies,
                   const std::vector<int> &near,
                   const Vector<dim> &position,
                   Node node);

    std::vector<Node> nodes;
  };
} // namespace magmpm
