#include <magmpm/base/constants.h>
#include <magmpm/elliptic/open_boundary.h>
#include <magmpm/elliptic/potential_operator.h>
#include <magmpm/elliptic/potential_solver.h>
#include <magmpm/magnetics/force_handover.h>
#include <magmpm/magnetics/magnetic_force.h>
#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/magnetics/potential_residual.h>
#include <magmpm/mesh/mirror_images.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/reduce.h>

namespace magmpm
{
  namespace
  {
    /**
     * When the preconditioner has served its time: as soon as CG needs twice the iterations per digit
     * that it needed at best since the last rebuild (two more are allowed, as iterations are whole
     * numbers).
     */
    class RebuildRule
    {
    public:
      bool
      is_due() const
      {
        return due;
      }

      void
      rebuilt()
      {
        due                  = false;
        iterations_per_digit = std::numeric_limits<double>::infinity();
      }

      void
      count(const int iterations, const double relative_tolerance)
      {
        const double digits  = std::max(0.5, -std::log10(relative_tolerance));
        iterations_per_digit = std::min(iterations_per_digit, iterations / digits);
        due                  = iterations > 2. * iterations_per_digit * digits + 2.;
      }

    private:
      bool due                    = true;
      double iterations_per_digit = 0.;
    };

    /**
     * Where to start the next solve: the last two solutions continued, if their like was nearer to the
     * last one than the one before it; otherwise the last one. Of one mesh.
     */
    class StartingGuess
    {
    public:
      void
      record(const PotentialVector &solution)
      {
        if (n_solutions > 1)
          is_nearer = distance(solution, continued) < distance(solution, last);
        if (n_solutions > 0)
          {
            continued = solution;
            continued.sadd(2., -1., last);
          }
        last = solution;
        ++n_solutions;
      }

      void
      put_into(PotentialVector &potential) const
      {
        if (is_nearer)
          potential = continued;
      }

    private:
      int n_solutions = 0;
      bool is_nearer  = false;
      PotentialVector last, continued;

      static double
      distance(PotentialVector one, const PotentialVector &other)
      {
        one -= other;
        return one.l2_norm();
      }
    };
  } // namespace

  template <int dim>
  struct PotentialProblem<dim>::Implementation : public NewtonProblem<PotentialVector>
  {
    Implementation(const BackgroundMesh<dim> &mesh,
                   const BlockPartition<dim> &partition,
                   const MagneticsParameters<dim> &parameters,
                   parallel::PhaseTimer &timer)
      : mesh(mesh)
      , partition(partition)
      , parameters(parameters)
      , timer(timer)
      , material(mesh, partition, parameters)
    {
    }

    /** Everything that depends on the mesh, which has changed. */
    void
    set_up();

    /** Brings the material, the sources and the open boundary up to date. */
    void
    set_state(const NodeField<dim> &content, const ExternalField<dim> &sources);

    void
    evaluate(const PotentialVector &potential, PotentialVector &result) override;

    int
    solve_linearized(const PotentialVector &rhs_negative,
                     const double relative_tolerance,
                     PotentialVector &step) override;

    LinearSolveResult
    run_cg(const PotentialVector &right_hand_side, const double tolerance, PotentialVector &step);

    JacobianData<dim>
    jacobian_data() const;

    /** Takes the tangents of the last evaluate(). */
    void
    update_jacobian();

    void
    rebuild_preconditioner();

    const BackgroundMesh<dim> &mesh;
    const BlockPartition<dim> &partition;
    const MagneticsParameters<dim> parameters;
    parallel::PhaseTimer &timer;

    PotentialSolution<dim> solution;
    unsigned int revision = 0; ///< of the mesh
    MaterialPoints<dim> material;
    std::unique_ptr<OpenBoundary<dim>> boundary;
    PotentialResidual<dim> residual;
    PotentialOperator<dim, double> jacobian;
    std::unique_ptr<PotentialSolver<dim>> solver;
    RebuildRule rule;
    StartingGuess start;
    bool has_rebuilt = false; ///< in this solve
  };

  template <int dim>
  void
  PotentialProblem<dim>::Implementation::set_up()
  {
    const parallel::PhaseTimer::Scope section(timer, "Set up potential");
    solver.reset();
    boundary.reset();
    jacobian.clear();
    solution.space = std::make_unique<const PotentialSpace<dim>>(
      mesh, parameters.preconditioner == Preconditioner::gmg);
    // Assignment would keep the old exchange pattern where the ranks own as many values as before.
    solution.potential.reinit(solution.space->make_vector());
    revision = mesh.revision();

    jacobian.initialize(solution.space->matrix_free);
    solver = make_potential_solver<dim>(parameters.preconditioner, *solution.space);
    rule   = RebuildRule();
    start  = StartingGuess();
  }

  template <int dim>
  void
  PotentialProblem<dim>::Implementation::set_state(const NodeField<dim> &content,
                                                   const ExternalField<dim> &sources)
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: material");
    const PotentialSpace<dim> &space = *solution.space;
    material.reinit(space.lattice_cells, content, sources);

    // Weights by |M| in the sources' field alone: the centre then depends on the present state only.
    const auto local = material.magnetized_weight();
    std::array<double, dim + 1> sums;
    std::copy_n(local.second.values, dim, sums.begin());
    sums[dim]          = local.first;
    sums               = parallel::sum(sums, mesh.communicator());
    Vector<dim> centre = 0.5 * (space.lower_corner + space.upper_corner);
    for (int d = 0; d < dim && sums[dim] > 0.; ++d)
      centre[d] = sums[d] / sums[dim];
    boundary = std::make_unique<OpenBoundary<dim>>(space, parameters.shielded, centre);

    dealii::FullMatrix<double> matrix;
    jacobian.set_boundary_matrices([&](const unsigned int batch, const unsigned int lane) {
      return boundary->element_matrix(space.matrix_free->get_cell_iterator(batch, lane), matrix)
               ? &matrix
               : nullptr;
    });
  }

  template <int dim>
  void
  PotentialProblem<dim>::Implementation::evaluate(const PotentialVector &potential,
                                                  PotentialVector &result)
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: residual");
    residual.evaluate(*solution.space, material, jacobian, potential, result);
  }

  template <int dim>
  JacobianData<dim>
  PotentialProblem<dim>::Implementation::jacobian_data() const
  {
    return {[this](const unsigned int cell) { return residual.permeability(material, cell); },
            *boundary};
  }

  template <int dim>
  void
  PotentialProblem<dim>::Implementation::rebuild_preconditioner()
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: preconditioner");
    solver->rebuild(jacobian_data());
    rule.rebuilt();
    has_rebuilt = true;
  }

  template <int dim>
  LinearSolveResult
  PotentialProblem<dim>::Implementation::run_cg(const PotentialVector &right_hand_side,
                                                const double tolerance,
                                                PotentialVector &step)
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: CG");
    return solver->solve(jacobian, right_hand_side, tolerance, parameters.max_cg_iterations, step);
  }

  template <int dim>
  void
  PotentialProblem<dim>::Implementation::update_jacobian()
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: Jacobian");
    const PotentialSpace<dim> &space = *solution.space;
    jacobian.set_permeability([&](const unsigned int batch, const unsigned int lane) {
      return residual.permeability(material, space.lattice_cell(batch, lane));
    });
    solver->update(jacobian_data());
  }

  template <int dim>
  int
  PotentialProblem<dim>::Implementation::solve_linearized(const PotentialVector &residual_vector,
                                                          const double relative_tolerance,
                                                          PotentialVector &step)
  {
    update_jacobian();
    const bool is_fresh = rule.is_due();
    if (is_fresh)
      rebuild_preconditioner();

    PotentialVector right_hand_side(residual_vector);
    right_hand_side *= -1.;
    const double tolerance   = relative_tolerance * right_hand_side.l2_norm();
    LinearSolveResult result = run_cg(right_hand_side, tolerance, step);
    if (!result.is_solved() && !is_fresh)
      {
        rebuild_preconditioner();
        result = run_cg(right_hand_side, tolerance, step);
      }
    if (!result.is_solved())
      throw RunError("The linear system of the magnetic potential was not solved " +
                     result.failure + ". Allow more iterations, or choose another preconditioner.");
    rule.count(result.iterations, relative_tolerance);
    return result.iterations;
  }

  template <int dim>
  PotentialProblem<dim>::PotentialProblem(const BackgroundMesh<dim> &mesh,
                                          const BlockPartition<dim> &partition,
                                          const MagneticsParameters<dim> &parameters,
                                          parallel::PhaseTimer &timer)
    : implementation(std::make_unique<Implementation>(mesh, partition, parameters, timer))
  {
  }

  template <int dim>
  PotentialProblem<dim>::~PotentialProblem() = default;

  template <int dim>
  SolveReport
  PotentialProblem<dim>::solve(const NodeField<dim> &content, const ExternalField<dim> &sources)
  {
    Implementation &problem    = *implementation;
    PotentialVector &potential = problem.solution.potential;
    if (!problem.solution.space || problem.revision != problem.mesh.revision())
      problem.set_up();
    problem.set_state(content, sources);
    problem.has_rebuilt = false;
    problem.start.put_into(potential);

    // The tolerance refers to the residual at zero potential, however good the start is.
    SolveReport report;
    PotentialVector zero = problem.solution.space->make_vector(), residual(zero);
    problem.evaluate(zero, residual);
    report.zero_residual = residual.l2_norm();
    if (report.zero_residual == 0.)
      potential = 0.;

    NewtonParameters newton;
    newton.tolerance              = problem.parameters.newton_tolerance * report.zero_residual;
    newton.max_steps              = problem.parameters.max_newton_steps;
    newton.is_linear              = problem.parameters.law == MagnetizationLaw::linear;
    newton.residual_without_start = report.zero_residual;
    report.newton                 = damped_newton<PotentialVector>(
      problem, newton, potential, potential.all_zero() ? &residual : nullptr);
    problem.start.record(potential);

    report.preconditioner_rebuilt = problem.has_rebuilt;
    report.energy                 = -constants::vacuum_permeability * problem.residual.energy();
    report.n_unknowns             = n_unknowns();
    report.clipped_fractions   = parallel::sum(problem.material.indicator().n_clipped_fractions(),
                                             problem.mesh.communicator());
    report.clipped_corrections = parallel::sum(problem.material.indicator().n_clipped_corrections(),
                                               problem.mesh.communicator());
    return report;
  }

  template <int dim>
  Vector<dim>
  PotentialProblem<dim>::compute_force(const NodeField<dim> &mass, NodeField<dim> &force) const
  {
    const Implementation &problem = *implementation;
    const parallel::PhaseTimer::Scope section(problem.timer, "Compute magnetic force");
    compute_split_force(problem.solution, problem.material, problem.partition, force);
    // The quadrature ends at a mirror, where stress does not: the force needs that of both sides.
    add_mirror_images_of_vector(
      problem.partition, problem.mesh.lattice(), problem.parameters.shielded, force);
    Vector<dim> dropped = hand_force_inward(problem.partition, mass, force);
    problem.partition.update_ghosts(force);
    dropped = parallel::sum(dropped, problem.mesh.communicator());
    return dropped;
  }

  template <int dim>
  void
  PotentialProblem<dim>::compute_field(NodeField<dim> &field) const
  {
    const Implementation &problem = *implementation;
    const parallel::PhaseTimer::Scope section(problem.timer, "Compute magnetic force");
    compute_material_field(problem.solution, problem.material, problem.partition, field);
  }

  template <int dim>
  const MaterialPoints<dim> &
  PotentialProblem<dim>::material() const
  {
    return implementation->material;
  }

  template <int dim>
  std::vector<MaterialSample<dim>>
  PotentialProblem<dim>::material_samples() const
  {
    return sample_material(implementation->solution, implementation->material);
  }

  template <int dim>
  unsigned long long
  PotentialProblem<dim>::n_unknowns() const
  {
    const auto &space = implementation->solution.space;
    return space ? space->dof_handler.n_dofs() : 0;
  }

  template <int dim>
  const PotentialSolution<dim> &
  PotentialProblem<dim>::solution() const
  {
    return implementation->solution;
  }

  template class PotentialProblem<2>;
  template class PotentialProblem<3>;
} // namespace magmpm
