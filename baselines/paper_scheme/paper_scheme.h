#pragma once

#include <magmpm/elliptic/newton_solver.h>

#include <baselines/paper_scheme/conjugate_gradients.h>
#include <baselines/paper_scheme/maxwell_force.h>
#include <baselines/paper_scheme/potential_stencil.h>

namespace magmpm::paper_scheme
{
  enum class Preconditioner
  {
    none,
    jacobi,
    incomplete_cholesky
  };

  enum class BoxFaces
  {
    shielded, ///< the paper's: zero normal difference
    open      ///< Robin condition of a dipole at the centre of the magnetized material
  };

  struct Parameters
  {
    MagnetizationLaw law          = MagnetizationLaw::langevin;
    BoxFaces faces                = BoxFaces::shielded;
    Preconditioner preconditioner = Preconditioner::incomplete_cholesky;
    double modification           = 0.98;  ///< of the incomplete Cholesky factors [-]
    double newton_tolerance       = 1e-10; ///< of the residual, relative to that of zero potential
    int max_newton_steps          = 25;
    int max_cg_iterations         = 5000;
  };

  /** What one solution took. */
  struct Report
  {
    NewtonReport newton;
    double zero_residual      = 0.; ///< norm at zero potential: the tolerance refers to it
    std::ptrdiff_t n_unknowns = 0;
    double cg_seconds         = 0.; ///< of wall time, in CG without setting up preconditioners
    double total_seconds      = 0.; ///< of wall time, from particles to the field

    double
    nanoseconds_per_unknown_and_iteration() const
    {
      return 1e9 * cg_seconds / (double(n_unknowns) * std::max(1, newton.linear_iterations));
    }
  };

  /**
   * The magnetic scheme of Sun et al. 2021, as a baseline: div_h(h + M(H_ext + h)) = 0 with
   * h = -G phi, everything on the nodes of one uniform grid over the whole potential box, G the
   * central differences, grain density smeared by P2G, Neumann faces, Newton's method with halving
   * of the step until the residual falls, force as divergence of the Maxwell stress.
   *
   * Made as fast as it gets without changing the discretization: the stencil is free of a matrix,
   * Newton's linear systems are solved no more exactly than needed, and the 2^dim constants of the
   * null space that central differences have are kept out of the right-hand side and the solution.
   * One thread. In 2D everything is per metre of depth.
   */
  template <int dim>
  class PaperScheme : private NewtonProblem<NodeVector>
  {
  public:
    /**
     * @param lower_corner  of the potential box [m].
     * @param n_nodes       along each axis, at least 6.
     * @param spacing       dx [m].
     */
    PaperScheme(const Vector<dim> &lower_corner,
                const Index<dim> &n_nodes,
                const double spacing,
                const Parameters &parameters);

    /**
     * Solves for the potential, starting from the last one, or from zero after reset().
     *
     * @throw InputError if particles are too close to a face.
     * @throw RunError if Newton's method or CG does not converge.
     */
    Report
    solve(const std::vector<Particle<dim>> &particles, const ExternalField<dim> &sources);

    /** Forgets the potential. */
    void
    reset();

    /** The nodes with material at the last solve. */
    const std::vector<MaterialNode<dim>> &
    nodes() const
    {
      return material;
    }

    /** M at a node with material [A/m]. */
    Vector<dim>
    magnetization_at(const MaterialNode<dim> &node) const
    {
      return magnetization(parameters.law, node.content, node.field());
    }

    /** Sum over the nodes of M dx^dim [A m^2]; in 2D [A m]. */
    Vector<dim>
    moment() const;

    /**
     * H at a point at least 1.5 dx within the box [A/m]: that of the sources is exact, h comes from
     * the nodes by quadratic B-splines.
     */
    Vector<dim>
    field(const Vector<dim> &position, const ExternalField<dim> &sources) const;

    /** Forces on nodes(), see maxwell_forces() [N]; in 2D [N/m]. */
    std::vector<Vector<dim>>
    forces(const ExternalField<dim> &sources,
           const ForceRegion region = ForceRegion::reached_nodes) const;

    const NodeGrid<dim> &
    node_grid() const
    {
      return grid;
    }

    /** On the nodes of the whole box [A]. */
    const NodeVector &
    potential() const
    {
      return phi;
    }

  private:
    const NodeGrid<dim> grid;
    const Parameters parameters;
    PotentialStencil<dim> vacuum;   ///< G^T G and open faces, for the residual
    PotentialStencil<dim> jacobian; ///< at the last potential
    NodeVector phi;
    std::vector<MaterialNode<dim>> material;
    std::vector<std::ptrdiff_t> numbers; ///< of the material nodes
    ConjugateGradientsMemory memory;
    double cg_seconds = 0.;

    void
    open_faces();

    void
    evaluate(const NodeVector &x, NodeVector &residual) override;

    int
    solve_linearized(const NodeVector &residual,
                     const double relative_tolerance,
                     NodeVector &step) override;

    template <typename PreconditionerType>
    int
    run_cg(const PreconditionerType &preconditioner,
           const NodeVector &residual,
           const double relative_tolerance,
           NodeVector &step);
  };
} // namespace magmpm::paper_scheme
