#include <deal.II/matrix_free/fe_evaluation.h>

#include <magmpm/elliptic/elliptic_operator.h>
#include <magmpm/elliptic/elliptic_problem.h>
#include <magmpm/elliptic/elliptic_residual.h>
#include <magmpm/elliptic/elliptic_solver.h>
#include <magmpm/elliptic/open_boundary.h>
#include <magmpm/elliptic/rebuild_rule.h>
#include <magmpm/elliptic/starting_guess.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/reduce.h>

namespace magmpm
{
  template <int dim>
  struct EllipticProblem<dim>::Implementation : public NewtonProblem<PotentialVector>
  {
    Implementation(const BackgroundMesh<dim> &mesh,
                   const EllipticParameters &parameters,
                   const std::string &unknown,
                   parallel::PhaseTimer &timer)
      : mesh(mesh)
      , parameters(parameters)
      , unknown(unknown)
      , timer(timer)
    {
    }

    /** Everything that depends on the mesh, which has changed. */
    void
    set_up();

    void
    evaluate(const PotentialVector &potential, PotentialVector &result) override;

    int
    solve_linearized(const PotentialVector &rhs_negative,
                     const double relative_tolerance,
                     PotentialVector &step) override;

    /** Whether Newton's method is better not started from a potential of zero. Collective. */
    bool
    is_stiff() const;

    /**
     * From a potential of zero to that of weak fields, roughly, if the residual is less there.
     *
     * @param residual_vector  that of the start, before and after.
     * @return iterations of CG.
     */
    int
    start_in_weak_field(PotentialVector &potential, PotentialVector &residual_vector);

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
    const EllipticParameters parameters;
    const std::string unknown;
    parallel::PhaseTimer &timer;

    EllipticSolution<dim> solution;
    unsigned int revision = 0; ///< of the mesh
    std::unique_ptr<OpenBoundary<dim>> boundary;
    const EllipticMedium<dim> *medium = nullptr; ///< in this solve
    MediumResponse response           = MediumResponse::full;
    EllipticResidual<dim> residual;
    EllipticOperator<dim, double> jacobian;
    std::unique_ptr<EllipticSolver<dim>> solver;
    RebuildRule rule;
    StartingGuess start;
    bool has_rebuilt = false; ///< in this solve
  };

  template <int dim>
  void
  EllipticProblem<dim>::Implementation::set_up()
  {
    const parallel::PhaseTimer::Scope section(timer, "Set up potential");
    solver.reset();
    boundary.reset();
    jacobian.clear();
    solution.space = std::make_unique<const EllipticSpace<dim>>(
      mesh, parameters.preconditioner == Preconditioner::gmg);
    // Assignment would keep the old exchange pattern where the ranks own as many values as before.
    solution.potential.reinit(solution.space->make_vector());
    revision = mesh.revision();

    jacobian.initialize(solution.space->matrix_free);
    solver = make_elliptic_solver<dim>(parameters.preconditioner, *solution.space);
    rule   = RebuildRule();
    start  = StartingGuess();
  }

  template <int dim>
  void
  EllipticProblem<dim>::Implementation::evaluate(const PotentialVector &potential,
                                                 PotentialVector &result)
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: residual");
    residual.evaluate(*solution.space, *medium, response, jacobian, potential, result);
  }

  template <int dim>
  JacobianData<dim>
  EllipticProblem<dim>::Implementation::jacobian_data() const
  {
    return {[this](const unsigned int cell) { return residual.coefficient(cell); }, *boundary};
  }

  template <int dim>
  void
  EllipticProblem<dim>::Implementation::rebuild_preconditioner()
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: preconditioner");
    solver->rebuild(jacobian_data());
    rule.rebuilt();
    has_rebuilt = true;
  }

  template <int dim>
  LinearSolveResult
  EllipticProblem<dim>::Implementation::run_cg(const PotentialVector &right_hand_side,
                                               const double tolerance,
                                               PotentialVector &step)
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: CG");
    return solver->solve(jacobian, right_hand_side, tolerance, parameters.max_cg_iterations, step);
  }

  template <int dim>
  void
  EllipticProblem<dim>::Implementation::update_jacobian()
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: Jacobian");
    const EllipticSpace<dim> &space = *solution.space;
    jacobian.set_coefficient([&](const unsigned int batch, const unsigned int lane) {
      return residual.coefficient(space.lattice_cell(batch, lane));
    });
    solver->update(jacobian_data());
  }

  template <int dim>
  int
  EllipticProblem<dim>::Implementation::solve_linearized(const PotentialVector &residual_vector,
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
      throw RunError("The linear system of the " + unknown + " was not solved " + result.failure +
                     ". Allow more iterations, or choose another preconditioner.");
    rule.count(result.iterations, relative_tolerance);
    return result.iterations;
  }

  template <int dim>
  bool
  EllipticProblem<dim>::Implementation::is_stiff() const
  {
    constexpr double stiff = 5.; // below, two to four steps of Newton's method do from zero as well
    return !medium->is_linear() &&
           parallel::max(medium->largest_weak_tangent(), mesh.communicator()) > stiff;
  }

  template <int dim>
  int
  EllipticProblem<dim>::Implementation::start_in_weak_field(PotentialVector &potential,
                                                            PotentialVector &residual_vector)
  {
    const double zero_residual = residual_vector.l2_norm();
    response                   = MediumResponse::weak_field;
    evaluate(potential, residual_vector);
    const int n_iterations = solve_linearized(residual_vector, 0.1, potential);
    response               = MediumResponse::full;
    evaluate(potential, residual_vector);
    if (!(residual_vector.l2_norm() < zero_residual))
      {
        potential = 0.;
        evaluate(potential, residual_vector);
      }
    return n_iterations;
  }

  template <int dim>
  EllipticProblem<dim>::EllipticProblem(const BackgroundMesh<dim> &mesh,
                                        const EllipticParameters &parameters,
                                        const std::string &unknown,
                                        parallel::PhaseTimer &timer)
    : implementation(std::make_unique<Implementation>(mesh, parameters, unknown, timer))
  {
  }

  template <int dim>
  EllipticProblem<dim>::~EllipticProblem() = default;

  template <int dim>
  void
  EllipticProblem<dim>::follow_mesh()
  {
    if (!implementation->solution.space ||
        implementation->revision != implementation->mesh.revision())
      implementation->set_up();
  }

  template <int dim>
  const std::vector<Index<dim>> &
  EllipticProblem<dim>::lattice_cells() const
  {
    return implementation->solution.space->lattice_cells;
  }

  template <int dim>
  Vector<dim>
  EllipticProblem<dim>::middle() const
  {
    const EllipticSpace<dim> &space = *implementation->solution.space;
    return 0.5 * (space.lower_corner + space.upper_corner);
  }

  template <int dim>
  void
  EllipticProblem<dim>::set_boundary(const std::array<bool, 2 * dim> &shielded,
                                     const Vector<dim> &centre)
  {
    Implementation &problem         = *implementation;
    const EllipticSpace<dim> &space = *problem.solution.space;
    problem.boundary                = std::make_unique<OpenBoundary<dim>>(space, shielded, centre);

    dealii::FullMatrix<double> matrix;
    problem.jacobian.set_boundary_matrices([&](const unsigned int batch, const unsigned int lane) {
      return problem.boundary->element_matrix(space.matrix_free->get_cell_iterator(batch, lane),
                                              matrix)
               ? &matrix
               : nullptr;
    });
  }

  template <int dim>
  EllipticReport
  EllipticProblem<dim>::solve(const EllipticMedium<dim> &medium)
  {
    Implementation &problem    = *implementation;
    PotentialVector &potential = problem.solution.potential;
    problem.medium             = &medium;
    problem.has_rebuilt        = false;
    problem.start.put_into(potential);

    // The tolerance refers to the residual at zero potential, however good the start is. One that is
    // worse than zero is none: Newton's method takes twice as long from there.
    EllipticReport report;
    const PotentialVector zero = problem.solution.space->make_vector();
    PotentialVector residual(zero);
    problem.evaluate(zero, residual);
    report.zero_residual = residual.l2_norm();
    bool is_from_zero    = potential.all_zero();
    if (!is_from_zero)
      problem.evaluate(potential, residual);
    if (!is_from_zero && !(residual.l2_norm() < report.zero_residual))
      {
        is_from_zero = true;
        potential    = 0.;
        problem.evaluate(potential, residual);
      }

    NewtonParameters newton;
    newton.tolerance              = problem.parameters.newton_tolerance * report.zero_residual;
    newton.max_steps              = problem.parameters.max_newton_steps;
    newton.is_linear              = medium.is_linear();
    newton.residual_without_start = report.zero_residual;
    int n_iterations_of_start     = 0;
    if (is_from_zero && report.zero_residual > 0. && problem.is_stiff())
      n_iterations_of_start = problem.start_in_weak_field(potential, residual);
    report.newton = damped_newton<PotentialVector>(problem, newton, potential, &residual);
    report.newton.linear_iterations += n_iterations_of_start;
    problem.start.record(potential);

    report.preconditioner_rebuilt = problem.has_rebuilt;
    report.minimum                = problem.residual.functional();
    report.n_unknowns             = n_unknowns();
    return report;
  }

  template <int dim>
  void
  EllipticProblem<dim>::for_gradients(
    const std::function<bool(const unsigned int)> &is_wanted,
    const std::function<
      void(const unsigned int, const PointVectors<dim> &, const OctantVectors<dim> &)> &action)
    const
  {
    const EllipticSpace<dim> &space  = *implementation->solution.space;
    const PotentialVector &potential = implementation->solution.potential;
    const auto &cells                = *space.matrix_free;

    potential.update_ghost_values();
    typename EllipticOperator<dim, double>::Evaluation phi(cells);
    typename EllipticOperator<dim, double>::OctantEvaluation octants(cells, 0, 1);
    PointVectors<dim> at_points;
    OctantVectors<dim> in_octants;
    for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
      {
        bool is_evaluated = false;
        for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
          {
            const unsigned int cell = space.lattice_cell(batch, lane);
            if (cell == invalid_entry || !is_wanted(cell))
              continue;
            if (!is_evaluated)
              {
                phi.reinit(batch);
                phi.read_dof_values(potential);
                octants.reinit(batch);
                octants.evaluate(phi.begin_dof_values(), dealii::EvaluationFlags::gradients);
                phi.evaluate(dealii::EvaluationFlags::gradients);
                is_evaluated = true;
              }
            for (int q = 0; q < n_points<dim>; ++q)
              for (int d = 0; d < dim; ++d)
                at_points[q][d] = phi.get_gradient(q)[d][lane];
            for (int q = 0; q < n_octants<dim>; ++q)
              for (int d = 0; d < dim; ++d)
                in_octants[q][d] = octants.get_gradient(q)[d][lane];
            action(cell, at_points, in_octants);
          }
      }
    potential.zero_out_ghost_values();
  }

  template <int dim>
  unsigned long long
  EllipticProblem<dim>::n_unknowns() const
  {
    const auto &space = implementation->solution.space;
    return space ? space->dof_handler.n_dofs() : 0;
  }

  template <int dim>
  const EllipticSolution<dim> &
  EllipticProblem<dim>::solution() const
  {
    return implementation->solution;
  }

  template class EllipticProblem<2>;
  template class EllipticProblem<3>;
} // namespace magmpm
