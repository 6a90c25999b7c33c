#pragma once

#include <magmpm/elliptic/newton_solver.h>

namespace magmpm
{
  /** What one solution of the potential problem took and gave. */
  struct SolveReport
  {
    NewtonReport newton;
    double zero_residual          = 0.; ///< norm at zero potential: the tolerance refers to it
    bool preconditioner_rebuilt   = false;
    double energy                 = 0.; ///< U = -mu_0 min Pi [J]; J/m in 2D
    unsigned long long n_unknowns = 0;

    unsigned long clipped_fractions   = 0; ///< nodes, see SharpIndicator
    unsigned long clipped_corrections = 0; ///< nodes, see SharpIndicator

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
      archive &energy;
      archive &n_unknowns;
      archive &clipped_fractions;
      archive &clipped_corrections;
    }
  };
} // namespace magmpm
