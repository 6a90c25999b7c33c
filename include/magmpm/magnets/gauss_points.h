#pragma once

#include <vector>

namespace magmpm
{
  /** A point of a quadrature rule on [0, 1]. */
  struct GaussPoint
  {
    double position, weight;
  };

  /** Gauss and Legendre's rule with 5 points: exact for polynomials of degree 9. */
  std::vector<GaussPoint>
  gauss_points();
} // namespace magmpm
