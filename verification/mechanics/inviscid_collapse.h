#pragma once

#include <vector>

namespace magmpm::verification
{
  /** The front of a collapsing column without viscosity: T = t sqrt(2 g/a), Z = x/a. */
  struct InviscidFront
  {
    double time;  ///< T
    double front; ///< Z that 99.5 % of the fluid is behind
    double toe;   ///< Z of the tip on the ground
    double area;  ///< of the fluid over that at the start, less 1: the error of the volume
  };

  /**
   * Collapse of a column a wide and 2 a high in a quarter plane with slippery ground and wall, in plane
   * strain, without viscosity, surface tension and air: potential flow, of which the surface is followed
   * with its potential (Longuet-Higgins and Cokelet, Proc. R. Soc. Lond. A 350, 1976). Boundary elements
   * that are straight, with potential and flux linear on each and the integrals in closed form; images
   * behind ground and wall; Runge and Kutta's fourth order in time; new nodes on cubic splines after each
   * step. The upper corner of the column is rounded by 0.06 a.
   *
   * @param times    T, ascending.
   * @param n_nodes  of the surface; they are about four times as dense at the tip as at the wall.
   */
  std::vector<InviscidFront>
  inviscid_fronts(const std::vector<double> &times, const int n_nodes);
} // namespace magmpm::verification
