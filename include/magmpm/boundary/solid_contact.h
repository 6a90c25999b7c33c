#pragma once

#include <magmpm/boundary/contact_law.h>
#include <magmpm/boundary/rigid_body.h>
#include <magmpm/boundary/rigid_vector.h>
#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>

#include <vector>

namespace magmpm
{
  /** Nodes up to 1.5 dx from a surface feel it, and particles up to 1.5 dx from these along each axis [m]. */
  template <int dim>
  inline double
  reach_of_contact(const Lattice<dim> &lattice)
  {
    return 1.5 * (1. + std::sqrt(static_cast<double>(dim))) * lattice.spacing;
  }

  /**
   * Contact of solids with walls and rigid bodies where they touch, not where their B-splines do: a
   * pressure by the gap on the nodes that are mostly solid (contact_law.h). What is left of the
   * conditions: stick and slip do not let go of what touches, see SolidContact::held().
   */
  template <int dim>
  class SolidContact
  {
  public:
    /** @param bodies  where they are at the moment of a call. */
    SolidContact(const Lattice<dim> &lattice,
                 const WallParameters<dim> &walls,
                 const std::vector<RigidBody<dim>> &bodies);

    /** Whether a face of the box is one of the surfaces: it slips or separates. */
    bool
    has_wall(const int face) const
    {
      return walls.condition[face] == WallCondition::slip ||
             walls.condition[face] == WallCondition::separate;
    }

    /** All bodies, also those without a surface. */
    const std::vector<RigidBody<dim>> &
    all_bodies() const
    {
      return bodies;
    }

    /** Whether any rigid body has a surface. */
    bool
    has_bodies() const;

    /** Whether there is any surface. */
    bool
    has_surfaces() const
    {
      bool result = has_bodies();
      for (int face = 0; face < 2 * dim; ++face)
        result = result || has_wall(face);
      return result;
    }

    /** From now on there is no contact, until somebody fills sums(). @param n_blocks  0: there will be none. */
    void
    reinit(const int n_blocks);

    NodeField<dim, ContactSums> &
    sums()
    {
      return the_sums;
    }

    /** Whether the velocity of a node with the mass @p mass [kg] is a matter of this contact. */
    bool
    acts_on(const int slot, const int n, const double mass) const
    {
      return the_sums.n_blocks() > 0 && the_sums.get(ContactSums::mass, slot, n) > 0.5 * mass;
    }

    /**
     * The velocity of node number @p n in @p slot after the pressure of contact and friction in a step. Free
     * bodies get the opposite impulse: see impulses(); of their friction touched_nodes() tell.
     */
    Vector<dim>
    pressed(const int slot,
            const int n,
            const Index<dim> &node,
            const double time_step,
            const double mass,
            Vector<dim> velocity);

    /**
     * The velocity that surfaces which slip and stick leave to what they touch: none away from them, faster
     * than gaps close. To be called after pressed(). What free bodies hold, see touched_nodes().
     */
    Vector<dim>
    held(const int slot,
         const int n,
         const Index<dim> &node,
         const double time_step,
         Vector<dim> velocity) const;

    /** A node at a free body, whose friction is a matter of what the body does in the step. */
    struct TouchedNode
    {
      int slot, number;
      int body;
      Vector<dim> normal; ///< out of the body
      double pressing;    ///< normal impulse that it got [N s]
      bool is_held;       ///< whether it may not leave a surface that slips or sticks
    };

    /** Those since reinit(), on this rank. */
    const std::vector<TouchedNode> &
    touched_nodes() const
    {
      return touched;
    }

    /** Impulse and angular impulse about their centres that bodies got on this rank since reinit(), by body. */
    const std::vector<RigidVector<dim>> &
    impulses() const
    {
      return impulses_on_bodies;
    }

    /** Of contact on this rank at the end of the step [J], and the depth of the deepest at its start [m]. */
    double
    energy() const
    {
      return the_energy;
    }

    double
    depth() const
    {
      return the_depth;
    }

  private:
    /** A surface at a node, and whose it is. */
    struct Surface
    {
      NodeSurface<dim> at_node;
      int body; ///< or none
    };
    static constexpr int none = -1;

    bool
    is_free(const Surface &surface) const
    {
      return surface.body != none && bodies[surface.body].is_free();
    }

    /** Whether a surface holds what is next to a node. */
    bool
    holds(const NodeSurface<dim> &surface) const;

    /** Calls f(surface) for the surfaces whose gap is known at a node. */
    template <typename Function>
    void
    for_surfaces(const int slot, const int n, const Index<dim> &node, const Function &f) const;

    /** The nearest body to a node that has a surface; its number, or none. */
    int
    find_nearest_body(const Vector<dim> &position) const;

    /** Gives a free body the opposite of an impulse at a node. */
    void
    add_reaction(const int body, const Vector<dim> &position, const Vector<dim> &impulse);

    /** Adds the energy at the end of the step. @param way  of the node in it, out of the surface [m]. */
    void
    note_energy(const NodeSolid<dim> &solid, const NodeSurface<dim> &surface, const double way);

    const Lattice<dim> lattice;
    const WallParameters<dim> walls;
    const std::vector<RigidBody<dim>> &bodies;
    NodeField<dim, ContactSums> the_sums;
    std::vector<RigidVector<dim>> impulses_on_bodies;
    std::vector<TouchedNode> touched;
    double the_energy = 0., the_depth = 0.;
  };
} // namespace magmpm
