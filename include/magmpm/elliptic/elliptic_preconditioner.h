#pragma once

#include <magmpm/elliptic/elliptic_solver.h>

namespace magmpm
{
  /**
   * A symmetric positive definite approximation of the inverse of the Jacobian, for deal.II's CG with
   * the Jacobian without a matrix.
   */
  template <int dim>
  class EllipticPreconditioner : public EllipticSolver<dim>
  {
  public:
    virtual void
    vmult(PotentialVector &dst, const PotentialVector &src) const = 0;

    LinearSolveResult
    solve(const EllipticOperator<dim, double> &jacobian,
          const PotentialVector &right_hand_side,
          const double tolerance,
          const int max_iterations,
          PotentialVector &x) override;
  };
} // namespace magmpm
