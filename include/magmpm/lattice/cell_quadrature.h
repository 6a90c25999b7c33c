#pragma once

#include <magmpm/lattice/cell_stencil.h>

#include <array>

namespace magmpm
{
  /**
   * Points along an axis of a mesh cell, on [0, 2] (half cell edges), and their weights, which sum to 2:
   * QGauss(2), QGauss(3), and for n = 4 QGauss(2) in each half of the cell.
   */
  template <int n>
  struct CellRule;

  template <>
  struct CellRule<2>
  {
    static constexpr double points[]  = {0.42264973081037423, 1.5773502691896257}; // 1 -+ 1/sqrt(3)
    static constexpr double weights[] = {1., 1.};
  };

  template <>
  struct CellRule<3>
  {
    static constexpr double points[]  = {0.2254033307585166,
                                         1.,
                                         1.7745966692414834}; // 1 -+ sqrt(3/5)
    static constexpr double weights[] = {5. / 9., 8. / 9., 5. / 9.};
  };

  template <>
  struct CellRule<4>
  {
    static constexpr double points[]  = {0.21132486540518712,
                                         0.78867513459481288,
                                         1.2113248654051871,
                                         1.7886751345948129};
    static constexpr double weights[] = {0.5, 0.5, 0.5, 0.5};
  };

  /** Points of QGauss(3), by which the potential is integrated exactly; per axis and in all, x fastest. */
  inline constexpr int n_points_1d = 3;
  template <int dim>
  inline constexpr int n_points = power(n_points_1d, dim);

  /** Points of QGauss(2), at which media are evaluated, one in each octant of the cell (2D: quadrant). */
  inline constexpr int n_octants_1d = 2;
  template <int dim>
  inline constexpr int n_octants = power(n_octants_1d, dim);

  /** On the n^dim points of a rule, x fastest. */
  template <int dim, int n>
  using PointValues = LaneArray<power(n, dim)>;

  /**
   * The n^dim points of a rule in mesh cells of one edge, 2 dx or dx, and quadratic B-splines of spacing
   * dx evaluated there and integrated over the cell, whose lower node is node 0. The points of all such
   * cells lie alike, so both are products of fixed n x 5 matrices, one axis after the other (sum
   * factorization).
   */
  template <int dim, int n>
  class CellQuadrature
  {
  public:
    using Values = PointValues<dim, n>;

    /** @param cell_edge  of the mesh cells, in dx: 2 or 1. @param spacing  dx [m]. */
    explicit CellQuadrature(const int cell_edge, const double spacing = 1.);

    static constexpr int
    size()
    {
      return power(n, dim);
    }

    /** A point (0 .. size() - 1), from the lower node of the cell [m]. */
    const Vector<dim> &
    offset(const int point) const
    {
      return offsets[point];
    }

    /** They sum to a cell [m^dim]. */
    double
    weight(const int point) const
    {
      return weights[point];
    }

    /** Sum_i N_i(x_q) values_i at every point. */
    void
    interpolate(const StencilValues<dim> &values, Values &result) const;

    /** The same with dN_i/dx_axis, in units of 1/dx. */
    void
    interpolate_derivative(const StencilValues<dim> &values, const int axis, Values &result) const;

    /** Adds Sum_q N_i(x_q) values_q for every node: the transpose of interpolate(). */
    void
    add_tested(const Values &values, StencilValues<dim> &result) const;

    /** The same with dN_i/dx_axis, in units of 1/dx. */
    void
    add_tested_by_derivative(const Values &values,
                             const int axis,
                             StencilValues<dim> &result) const;

  private:
    std::array<Vector<dim>, power(n, dim)> offsets;
    std::array<double, power(n, dim)> weights;
    double value_matrix[n][stencil_edge];
    double derivative_matrix[n][stencil_edge];
  };

  /** The octant in which a point of the rule n = 4 lies. */
  template <int dim>
  constexpr int
  octant_of_point(const int point)
  {
    int octant = 0;
    for (int d = 0, rest = point; d < dim; ++d, rest /= 4)
      octant += power(n_octants_1d, d) * (rest % 4 / 2);
    return octant;
  }
} // namespace magmpm
