#pragma once

#include <magmpm/elliptic/elliptic_operator.h>
#include <magmpm/elliptic/elliptic_parameters.h>
#include <magmpm/elliptic/elliptic_space.h>
#include <magmpm/elliptic/linear_solve_result.h>
#include <magmpm/elliptic/open_boundary.h>

#include <functional>
#include <memory>

namespace magmpm
{
  /** What the Jacobian is made of: see EllipticOperator. */
  template <int dim>
  struct JacobianData
  {
    /** K of a lattice cell, or a null pointer where no medium is. */
    std::function<const CellCoefficient<dim> *(const unsigned int)> coefficient;

    const OpenBoundary<dim> &boundary;
  };

  /**
   * Conjugate gradients for the linear systems of Newton's method. The Jacobian is that of the present
   * step, always; what approximates its inverse may be of an earlier one, since it is dear to set up.
   */
  template <int dim>
  class EllipticSolver
  {
  public:
    virtual ~EllipticSolver() = default;

    /** Takes over the Jacobian of the next solves, as far as this solver has its own. Collective. */
    virtual void
    update(const JacobianData<dim> &)
    {
    }

    /** Adapts the preconditioner to the Jacobian, that of the last update(). Collective. */
    virtual void
    rebuild(const JacobianData<dim> &jacobian) = 0;

    /**
     * Solves Jacobian x = right_hand_side, starting from zero. Collective.
     *
     * @param jacobian   the one of the last update(), without a matrix.
     * @param tolerance  on the norm of the residual, absolute.
     * @param x          fitting @p right_hand_side; hanging nodes not filled in.
     */
    virtual LinearSolveResult
    solve(const EllipticOperator<dim, double> &jacobian,
          const PotentialVector &right_hand_side,
          const double tolerance,
          const int max_iterations,
          PotentialVector &x) = 0;
  };

  /** The solver that the parameters ask for, on one state of the mesh; to be rebuilt first. */
  template <int dim>
  std::unique_ptr<EllipticSolver<dim>>
  make_elliptic_solver(const Preconditioner type, const EllipticSpace<dim> &space);
} // namespace magmpm
