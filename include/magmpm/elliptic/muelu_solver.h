#pragma once

#include <magmpm/elliptic/elliptic_solver.h>
#include <magmpm/elliptic/jacobian_assembler.h>
#include <magmpm/elliptic/tpetra_solver.h>

#include <memory>

namespace magmpm
{
  /**
   * The Jacobian assembled into Tpetra in every step of Newton's method, Belos' CG preconditioned by
   * MueLu. This is the solver that runs on a GPU, see TpetraSolver.
   */
  template <int dim>
  class MueLuSolver : public EllipticSolver<dim>
  {
  public:
    explicit MueLuSolver(const EllipticSpace<dim> &space);

    void
    update(const JacobianData<dim> &jacobian) override;

    void
    rebuild(const JacobianData<dim> &jacobian) override;

    LinearSolveResult
    solve(const EllipticOperator<dim, double> &jacobian,
          const PotentialVector &right_hand_side,
          const double tolerance,
          const int max_iterations,
          PotentialVector &x) override;

  private:
    const JacobianAssembler<dim> assembler;
    std::unique_ptr<TpetraSolver> solver;
  };
} // namespace magmpm
