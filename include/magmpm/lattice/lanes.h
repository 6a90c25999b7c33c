#pragma once

#include <magmpm/lattice/lattice.h>

#include <cstring>

namespace magmpm
{
  /**
   * The four lanes of a node as one value with component-wise arithmetic: a SIMD register where the
   * processor has one of that width (the compiler splits it where it has not). The one place where
   * the project uses compiler vector types.
   */
  using Lanes = double __attribute__((vector_size(n_lanes * sizeof(double))));

  inline Lanes
  load_lanes(const double *address)
  {
    Lanes lanes;
    std::memcpy(&lanes, address, sizeof(lanes));
    return lanes;
  }

  inline void
  store_lanes(const Lanes &lanes, double *address)
  {
    std::memcpy(address, &lanes, sizeof(lanes));
  }
} // namespace magmpm
