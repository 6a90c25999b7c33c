#pragma once

#include <magmpm/boundary/fluid_constraints.h>
#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/rigid_vector.h>

#include <array>
#include <vector>

namespace magmpm
{
  /**
   * What fluids and rigid bodies do to each other at the surfaces of these, in a step. The impulse lambda of a
   * constraint changes velocities, and the momentum of the body, by
   *   v_i <- v_i + (W_i/m_i) lambda,   W_g = 1,   b <- b - sum_i W_i B_i^T lambda,
   * with u_i = B_i V the body's velocity at a node: momentum and angular momentum are kept. stick: w = 0; slip:
   * n.w = 0; separate: n.w >= 0, n.lambda >= 0, one of them zero; friction takes away the tangential part of w
   * as far as Coulomb's law lets it. Without friction these are the velocities nearest to those before, in the
   * metric of the masses of nodes and bodies, that obey all constraints.
   *
   * Gauss-Seidel (sequential impulses): the energy of the metric falls with each of its steps. Since a light body
   * moves with the node that was looked at last, and comes to rest slowly among many, impulses that push all nodes
   * of a body as its motions do are found at once in between.
   *
   * All ranks solve for all constraints alike, which are as many as the nodes in a layer of 1.5 dx under the wetted
   * surfaces.
   */
  template <int dim>
  class FluidContact
  {
  public:
    explicit FluidContact(const std::vector<FluidConstraint<dim>> &constraints);

    /** Finds the impulses, and gives free bodies theirs. @return the number of sweeps. */
    int
    solve(std::vector<RigidBody<dim>> &bodies);

    /**
     * Gives the owned nodes their velocities; @p boundary has the last word.
     *
     * @param unconstrained  as of TouchedNodes::apply().
     */
    void
    apply(const BlockSet<dim> &blocks,
          const LatticeBoundary<dim> &boundary,
          NodeField<dim> &field,
          NodeField<dim> &unconstrained) const;

  private:
    static constexpr int max_terms = 1 + (1 << dim);

    /** The impulse of a constraint. */
    struct Impulse
    {
      Vector<dim> value;               ///< lambda [N s]
      Vector<dim> start;               ///< w before all [m/s]
      double along_normal, tangential; ///< w by an impulse of one, at most [1/kg]
      double common;       ///< the same along the normal without the body, if all are pushed alike
      ContactShare active; ///< what of it would follow a change of w
      std::array<int, max_terms> nodes; ///< of the terms
    };

    struct Node
    {
      Index<dim> index;
      double mass;
      Vector<dim> velocity;
    };

    /** All that impulses change. */
    struct State
    {
      std::vector<Impulse> impulses; ///< by constraint
      std::vector<Node> nodes;
      std::vector<RigidVector<dim>> motions; ///< by body
    };

    void
    number_nodes();

    /** The mobilities of the constraints. */
    void
    find_mobilities();

    /** w of constraint @p i. */
    Vector<dim>
    relative_velocity(const State &state, const std::size_t i) const;

    void
    add_impulse(const std::size_t i, const Vector<dim> &change, State &state) const;

    /** What contact allows of an impulse. */
    Vector<dim>
    allowed(const std::size_t i, const Vector<dim> &wanted, ContactShare &active) const;

    /** Goes through the constraints. @return the largest change of a velocity [m/s]. */
    double
    sweep();

    /** The impulse on constraint @p i of its body's motion @p k. */
    Vector<dim>
    pattern(const std::size_t i, const int k) const;

    /** Impulses that push all nodes of a body as its motions do, the best of them, if they are allowed. */
    void
    push_together(const int body);

    /** Energy of the metric less that at the start [J]. */
    double
    energy(const State &state) const;

    const std::vector<FluidConstraint<dim>> constraints;
    State now;
    std::vector<SurfaceContact> contacts; ///< by body
    std::vector<RigidMatrix<dim>>
      mobilities; ///< inverse mass and inertia, by body; zero if it is not free
  };
} // namespace magmpm
