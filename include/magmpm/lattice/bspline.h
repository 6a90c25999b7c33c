#pragma once

#include <magmpm/lattice/lattice.h>

namespace magmpm
{
  /** Nodes that a quadratic B-spline reaches in one direction. */
  inline constexpr int stencil_width = 3;

  /**
   * Quadratic B-spline weights of the three nodes around a point, Eq. (29) of Sun et al. 2021 (with
   * the outer branch 1/2 (3/2 - |x|)^2).
   *
   * @param offset   distance from the first node, in units of dx; in [0.5, 1.5).
   * @param weights  N at the three nodes; they sum to one and reproduce linear functions.
   *
   * @tparam Number  double, or Simd.
   */
  template <typename Number>
  inline void
  quadratic_bspline(const Number &offset, Number (&weights)[stencil_width])
  {
    weights[0] = 0.5 * (1.5 - offset) * (1.5 - offset);
    weights[1] = 0.75 - (offset - 1.) * (offset - 1.);
    weights[2] = 0.5 * (offset - 0.5) * (offset - 0.5);
  }

  /** Derivatives of the same weights with respect to the point, in units of 1/dx. */
  template <typename Number>
  inline void
  quadratic_bspline_derivative(const Number &offset, Number (&derivatives)[stencil_width])
  {
    derivatives[0] = offset - 1.5;
    derivatives[1] = -2. * (offset - 1.);
    derivatives[2] = offset - 0.5;
  }

  /**
   * Calls f(node, weight) for the 3^dim nodes whose B-splines reach @p position, x fastest, with the
   * products of their weights. One particle at a time: the kernels of P2G and G2P take many.
   */
  template <int dim, typename Function>
  inline void
  for_stencil(const Lattice<dim> &lattice, const Vector<dim> &position, const Function &f)
  {
    const Index<dim> base = lattice.base_node(position);
    const Vector<dim> x   = lattice.reduced(position);
    double weights[dim][stencil_width];
    for (int d = 0; d < dim; ++d)
      quadratic_bspline(x[d] - base[d], weights[d]);
    for (int i = 0; i < power(stencil_width, dim); ++i)
      {
        Index<dim> node = base;
        double weight   = 1.;
        for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_width)
          {
            node[d] += rest % stencil_width;
            weight *= weights[d][rest % stencil_width];
          }
        f(node, weight);
      }
  }
} // namespace magmpm
