#pragma once

#include <magmpm/lattice/node_field.h>
#include <magmpm/lattice/node_window.h>

#include <array>

namespace magmpm
{
  /** Points of the Gauss quadrature in a mesh cell, per axis and in all; x fastest. */
  inline constexpr int n_points_1d = 3;
  template <int dim>
  inline constexpr int n_points = power(n_points_1d, dim);

  /** Lattice nodes whose B-splines reach into a mesh cell of edge 2 dx: -1 .. 3 per axis (dx: -1 .. 2). */
  inline constexpr int stencil_edge = 5;
  template <int dim>
  inline constexpr int n_stencil_nodes = power(stencil_edge, dim);

  /** Four lanes on each of @p n places, named as those of a field. */
  template <int n>
  struct LaneArray : public std::array<double, n * n_lanes>
  {
    template <typename Quantities>
    double
    get(const NodeScalar<Quantities> quantity, const int i) const
    {
      return (*this)[i * n_lanes + quantity.lane];
    }

    template <typename Quantities>
    void
    set(const NodeScalar<Quantities> quantity, const int i, const double value)
    {
      (*this)[i * n_lanes + quantity.lane] = value;
    }

    template <int dim, typename Quantities>
    void
    set(const NodeVector<Quantities> quantity, const int i, const Vector<dim> &vector)
    {
      std::copy_n(vector.values, dim, this->data() + i * n_lanes + quantity.lane);
    }
  };

  /** On the nodes of the stencil, x fastest. */
  template <int dim>
  using StencilValues = LaneArray<n_stencil_nodes<dim>>;

  /** On the quadrature points of a cell, x fastest. */
  template <int dim>
  using PointValues = LaneArray<n_points<dim>>;

  /**
   * Quadratic B-splines of spacing dx, evaluated at the points of QGauss(3) in a mesh cell of edge
   * 2 dx (or dx) whose lower node is node 0, and integrated over it. The points of all such cells lie
   * alike, so both are products of fixed 3 x 5 matrices, one axis after the other (sum factorization).
   */
  template <int dim>
  class CellStencil
  {
  public:
    /** @param cell_edge  of the mesh cells, in dx: 2 or 1. */
    explicit CellStencil(const int cell_edge);

    /** Coordinates of the Gauss points on [0, 2] and their weights (sum 2): half cell edges. */
    static const std::array<double, n_points_1d> points_1d;
    static const std::array<double, n_points_1d> weights_1d;

    /**
     * Reads up to four lanes of the nodes around a cell. Nodes of blocks that are not active count as
     * zero, as lanes do that the field has not.
     *
     * @param slot    of the cell's block.
     * @param corner  the cell's lower node within the block: 0 .. 3 per axis.
     */
    void
    gather(const NodeNumbers<dim> &field,
           const BlockSet<dim> &blocks,
           const int slot,
           const Index<dim> &corner,
           StencilValues<dim> &values) const;

    /** Adds the lanes of the field to the nodes around a cell, apart from those that are not active. */
    void
    scatter_add(const StencilValues<dim> &values,
                const BlockSet<dim> &blocks,
                const int slot,
                const Index<dim> &corner,
                NodeNumbers<dim> &field) const;

    /** Sum_i N_i(x_q) values_i at every quadrature point. */
    void
    interpolate(const StencilValues<dim> &values, PointValues<dim> &result) const;

    /** The same with dN_i/dx_axis, in units of 1/dx. */
    void
    interpolate_derivative(const StencilValues<dim> &values,
                           const int axis,
                           PointValues<dim> &result) const;

    /** Adds Sum_q N_i(x_q) values_q for every node: the transpose of interpolate(). */
    void
    add_tested(const PointValues<dim> &values, StencilValues<dim> &result) const;

    /** The same with dN_i/dx_axis, in units of 1/dx. */
    void
    add_tested_by_derivative(const PointValues<dim> &values,
                             const int axis,
                             StencilValues<dim> &result) const;

  private:
    double value_matrix[n_points_1d][stencil_edge];
    double derivative_matrix[n_points_1d][stencil_edge];

    /** Calls f(place in the stencil, slot or invalid_slot, node in its block). */
    template <typename Function>
    static void
    for_each_node(const BlockSet<dim> &blocks,
                  const int slot,
                  const Index<dim> &corner,
                  const Function &f);
  };
} // namespace magmpm
