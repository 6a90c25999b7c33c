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

  /** Legendre's polynomial P_n and its derivative at a place in [-1, 1]. */
  struct Legendre
  {
    double value, slope;
  };

  Legendre
  legendre(const int n, const double x);
} // namespace magmpm::verification
