#include <deal.II/lac/solver_cg.h>

#include <magmpm/elliptic/elliptic_preconditioner.h>

namespace magmpm
{
  template <int dim>
  LinearSolveResult
  EllipticPreconditioner<dim>::solve(const EllipticOperator<dim, double> &jacobian,
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

  template class EllipticPreconditioner<2>;
  template class EllipticPreconditioner<3>;
} // namespace magmpm
