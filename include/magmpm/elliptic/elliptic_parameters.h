#pragma once

namespace magmpm
{
  enum class Preconditioner
  {
    gmg,  ///< geometric multigrid on deal.II's MatrixFree
    ml,   ///< algebraic multigrid on the assembled matrix: Trilinos ML, on Epetra
    muelu ///< the same: Trilinos MueLu, with matrix and CG on Tpetra
  };

  /** How an elliptic problem is solved. */
  struct EllipticParameters
  {
    Preconditioner preconditioner = Preconditioner::gmg;
    double newton_tolerance       = 1e-10; ///< of the residual, relative to that of zero potential
    int max_newton_steps          = 25;
    int max_cg_iterations         = 500;
  };
} // namespace magmpm
