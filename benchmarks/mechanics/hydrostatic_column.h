#pragma once

namespace magmpm::benchmarks
{
  /**
   * Pressure in a fluid at rest between slip walls: in each layer one cell thick, the mean of
   * p = K (1 - J) over its particles against the weight of what is above the middle of the layer.
   *
   * @param cells  of the lattice over the depth H of the fluid.
   * @return the largest error of a layer over rho g H.
   */
  double
  hydrostatic_error(const int cells);
} // namespace magmpm::benchmarks
