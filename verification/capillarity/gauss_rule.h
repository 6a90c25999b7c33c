#pragma once

#include <vector>

namespace magmpm::verification
{
  /** Points and weights on [0, 1]. */
  struct GaussRule
  {
    std::vector<double> points, weights;
  };

  /** Of Gauss: exact for polynomials of degree 2 n - 1. */
  GaussRule
  gauss_rule(const int n);

  /** The points of Gauss and Lobatto on [0, 1], both ends among them, for interpolation. @param n  at least 2. */
  std::vector<double>
  lobatto_points(const int n);

  struct ValueAndSlope
  {
    double value, slope;
  };

  /** Legendre's polynomial P_n at a place in [-1, 1]. */
  ValueAndSlope
  legendre(const int n, const double x);

  /** Lagrange's polynomial that is 1 at places[i] and 0 at all others. */
  ValueAndSlope
  lagrange(const std::vector<double> &places, const int i, const double x);
} // namespace magmpm::verification
