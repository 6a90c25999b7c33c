#pragma once

#include <magmpm/elliptic/elliptic_report.h>

namespace magmpm
{
  /** What one solution of the potential problem took and gave. */
  struct SolveReport : EllipticReport
  {
    double energy = 0.; ///< U = -mu_0 min Pi [J]; J/m in 2D

    unsigned long clipped_fractions   = 0; ///< nodes, see SharpIndicator
    unsigned long clipped_corrections = 0; ///< nodes, see SharpIndicator

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int version)
    {
      EllipticReport::serialize(archive, version);
      archive &energy;
      archive &clipped_fractions;
      archive &clipped_corrections;
    }
  };
} // namespace magmpm
