#include <deal.II/lac/solver_cg.h>

#include <magmpm/elliptic/potential_preconditioner.h>

namespace magmpm
{
  template <int dim>
  LinearSolveResult
  PotentialPreconditioner<dim>::solve(const PotentialOperator<dim, double> &jacobian,
                                      const PotentialVector &right_hand_side,
                                      const double tolerance,
                                      const int max_iterations,
                                      PotentialVector &x)
  {
    dealii::SolverControl control(max_iterations, tolerance);
    dealii::SolverCG<PotentialVector> cg(control);
    x = 0.;
    try
      {
        cg.solve(jacobian, x, right_hand_side, *this);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return LinearSolveResult::unsolved_in(static_cast<int>(control.last_step()));
      }
    return {static_cast<int>(control.last_step()), ""};
  }

  template class PotentialPreconditioner<2>;
  template class PotentialPreconditioner<3>;
} // namespace magmpm
