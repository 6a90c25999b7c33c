#pragma once

#include <magmpm/elliptic/newton_solver.h>

namespace magmpm
{
  /** What one solution of an elliptic problem took. */
  struct EllipticReport
  {
    NewtonReport newton;
    double zero_residual          = 0.; ///< norm at zero potential: the tolerance refers to it
    bool preconditioner_rebuilt   = false;
    double minimum                = 0.; ///< of the functional Pi whose derivative is the residual
    unsigned long long n_unknowns = 0;

    /** Residual at the start over that at zero potential: 1 from zero, smaller from the last solution. */
    double
    relative_initial_residual() const
    {
      return zero_residual > 0. ? newton.residuals.front() / zero_residual : 0.;
    }

    double
    relative_final_residual() const
    {
      return zero_residual > 0. ? newton.residuals.back() / zero_residual : 0.;
    }

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &newton;
      archive &zero_residual;
      archive &preconditioner_rebuilt;
      archive &minimum;
      archive &n_unknowns;
    }
  };
} // namespace magmpm
