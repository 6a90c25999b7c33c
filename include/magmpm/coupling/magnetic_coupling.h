#pragma once

#include <magmpm/lattice/node_field.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/simulation/domain_decomposition.h>
#include <magmpm/simulation/run_state.h>

#include <mpi.h>

#include <memory>
#include <optional>
#include <vector>

namespace magmpm::parallel
{
  class PhaseTimer;
}

namespace magmpm
{
  template <int dim>
  class PotentialProblem;

  /**
   * The potential problem and the particles that make its material and carry its force: when it is
   * solved, and what happens to the force between two solves. What it must remember of them is part of
   * the RunState, so that a checkpoint holds it.
   */
  template <int dim>
  class MagneticCoupling
  {
  public:
    /** All of these must outlive this object. */
    MagneticCoupling(const Parameters<dim> &parameters,
                     const DomainDecomposition<dim> &decomposition,
                     ExternalField<dim> &external_field,
                     parallel::PhaseTimer &timer,
                     const MPI_Comm communicator);
    ~MagneticCoupling();

    /**
     * Whether the force that particles carry no longer serves. Lets it rest at its last value if the
     * material only vibrates. Collective.
     */
    bool
    is_due(std::vector<Body<dim>> &bodies, RunState &state) const;

    /** Solves the potential and lets the particles carry the force, Eqs. (25-33). Collective. */
    void
    solve(std::vector<Body<dim>> &bodies, RunState &state);

    /** Lets the force that particles carry follow the motion since the last solve. */
    void
    advance_force(std::vector<Body<dim>> &bodies, RunState &state) const;

    /**
     * Finds what the material does to the sources, if the last solve did not and its mesh is still
     * there. Collective.
     */
    void
    update_reactions(RunState &state) const;

    /** Finds the potential on the present mesh, if that changed since the last solve. Collective. */
    void
    solve_for_output(std::vector<Body<dim>> &bodies, RunState &state);

    const PotentialProblem<dim> &
    potential() const
    {
      return *problem;
    }

  private:
    /** Finds the potential of the present material, Eqs. (25)-(30). */
    void
    solve_potential(std::vector<Body<dim>> &bodies, RunState &state);

    /** The densities of grains on the nodes, summed over the ranks, ghosts up to date. */
    NodeField<dim>
    magnetic_content(std::vector<Body<dim>> &bodies) const;

    /** What the material does to the sources. @param way  since they were found last, or 0 [m]. */
    void
    find_reactions(const double way, RunState &state) const;

    /** Accelerations of the nodes [m/s^2] by the magnetic force. */
    NodeField<dim>
    nodal_accelerations(std::vector<Body<dim>> &bodies, RunState &state) const;

    /** Gives particles the accelerations of the nodes [m/s^2], and their rate of change. */
    void
    carry_force(const NodeField<dim> &accelerations,
                std::vector<Body<dim>> &bodies,
                RunState &state) const;

    const Parameters<dim> &parameters;
    const DomainDecomposition<dim> &decomposition;
    ExternalField<dim> &external_field;
    const MPI_Comm communicator;

    std::unique_ptr<PotentialProblem<dim>> problem;
    std::optional<unsigned int> mesh_of_last_solve; ///< its revision
  };
} // namespace magmpm
