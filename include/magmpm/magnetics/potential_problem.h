#pragma once

#include <magmpm/elliptic/elliptic_problem.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/magnetics/magnetics_parameters.h>
#include <magmpm/magnetics/material_points.h>
#include <magmpm/magnetics/material_sample.h>
#include <magmpm/magnetics/solve_report.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/mesh/block_partition.h>

#include <vector>

namespace magmpm
{
  /**
   * The magnetic scalar potential of the scene: finds phi with h = -grad phi, H = H_ext + h and
   *   div(h + M(H)) = 0,
   * Eq. (13) of Sun et al. 2021, on the mesh of the potential box with open or shielded faces: an
   * EllipticProblem whose flux is q = grad phi - M(H_ext - grad phi), that of the MaterialPoints, and
   * whose functional is Pi = int [|h|^2/2 + psi(H)] + int c phi^2/2. H_ext^2, which reaches 1e12 near
   * magnets, never enters. Sees material as node fields only.
   *
   * In 2D everything is infinite along z: forces are per metre of depth.
   */
  template <int dim>
  class PotentialProblem
  {
  public:
    /** All of these must outlive this object; the mesh may still be unrefined. */
    PotentialProblem(const BackgroundMesh<dim> &mesh,
                     const BlockPartition<dim> &partition,
                     const MagneticsParameters<dim> &parameters,
                     parallel::PhaseTimer &timer);

    /**
     * Solves for the present material and sources. Starts from the last potential, or from the last two
     * continued, and from zero after a change of the mesh, for which it sets everything up anew.
     * Collective.
     *
     * @param content  on the nodes of the active blocks, with the images behind shielded walls, ghosts
     *                 updated.
     * @throw RunError if Newton's method or CG does not converge, with the residuals.
     */
    SolveReport
    solve(const NodeField<dim, NodeContent> &content, const ExternalField<dim> &sources);

    /**
     * The magnetic force on the material at the last solve:
     *   f_i = mu_0 int [-h ((h + M).grad N_i) + |h|^2/2 grad N_i] + int N_i mu_0 (M.grad) H_ext,
     * what the material does to itself and what the sources do to it; N_i are the B-splines of the
     * particles. Force that falls on the two layers of nodes around those with mass is handed inward,
     * so that the total is that on the material. The partition must be that of the last solve. Collective.
     *
     * @param mass   of the nodes [kg], with the images that material has behind shielded walls, ghosts
     *               updated.
     * @param force  [N] on owned nodes with mass, likewise with images; zero elsewhere.
     * @return the force further out, which is left away [N], of all ranks.
     */
    Vector<dim>
    compute_force(const NodeField<dim, SingleScalar> &mass,
                  NodeField<dim, SingleVector> &force) const;

    /**
     * The field in the material at the last solve, as its mean around each node:
     * int f N_i H / int f N_i. The partition must be that of the last solve. Collective.
     *
     * @param field  H [A/m], ghosts updated; zero where no material is.
     */
    void
    compute_field(NodeField<dim, SingleVector> &field) const;

    /** The medium of this rank at the last solve; valid until the next one. */
    const MaterialPoints<dim> &
    material() const
    {
      return points;
    }

    /** Its points with the fields there, in the order of material(), for integrals over them. */
    std::vector<MaterialSample<dim>>
    material_samples() const;

    /** Degrees of freedom of the potential, of all ranks; zero before the first solve. */
    unsigned long long
    n_unknowns() const
    {
      return potential.n_unknowns();
    }

    /**
     * The potential of the last solve and the space it lives in, for output and tests; valid until the
     * next one. Includes elliptic_space.h to be read.
     */
    const EllipticSolution<dim> &
    solution() const
    {
      return potential.solution();
    }

  private:
    const BackgroundMesh<dim> &mesh;
    const BlockPartition<dim> &partition;
    const MagneticsParameters<dim> parameters;
    parallel::PhaseTimer &timer;

    EllipticProblem<dim> potential;
    MaterialPoints<dim> points;

    /** Brings the material, the sources and the open boundary up to date. */
    void
    set_state(const NodeField<dim, NodeContent> &content, const ExternalField<dim> &sources);
  };
} // namespace magmpm
