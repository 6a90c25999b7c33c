#pragma once

#include <string>

namespace magmpm::verification
{
  /** A pool whose fluid starts hydrostatic. */
  struct HydrostaticPool
  {
    int dim            = 2;      ///< in 3D four cells across
    int cells          = 16;     ///< of the lattice over the depth H, a multiple of eight
    double compression = 0.05;   ///< rho g H/K
    std::string walls  = "slip"; ///< their condition
    bool is_under_oil =
      false; ///< the upper half is oil of 0.8 of the density and half of the modulus
  };

  /**
   * The largest root mean square of the particles' speed in any of the first steps, over that of sound in the pool,
   * c = sqrt(K/rho); a fluid at rest has 0.
   */
  double
  hydrostatic_unrest(const HydrostaticPool &pool, const int n_steps = 200);
} // namespace magmpm::verification
