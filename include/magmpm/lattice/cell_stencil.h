#pragma once

#include <magmpm/lattice/node_field.h>

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

  /** Four lanes on the nodes of the stencil, x fastest. */
  template <int dim>
  using StencilValues = std::array<double, n_stencil_nodes<dim> * n_lanes>;

  /** Four lanes on the quadrature points of a cell, x fastest. */
  template <int dim>
  using PointValues = std::array<double, n_points<dim> * n_lanes>;

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
     * Reads the nodes around a cell; nodes of blocks that are not active count as zero.
     *
     * @param slot    of the cell's block.
     * @param corner  the cell's lower node within the block: 0 .. 3 per axis.
     */
    void
    gather(const NodeField<dim> &field,
           const BlockSet<dim> &blocks,
           const int slot,
           const Index<dim> &corner,
           StencilValues<dim> &values) const;

    /** Adds to the nodes around a cell, apart from those of blocks that are not active. */
    void
    scatter_add(const StencilValues<dim> &values,
                const BlockSet<dim> &blocks,
                const int slot,
                const Index<dim> &corner,
                NodeField<dim> &field) const;

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
    /** Where a node of the stencil lies, seen from the block of the cell. */
    struct Place
    {
      int neighbour; ///< of the block, see BlockSet::neighbours()
      int node;      ///< in that block
    };

    using Places = std::array<Place, n_stencil_nodes<dim>>;
    std::array<Places, nodes_per_block<dim>> places; ///< by lower node of the cell in its block
    double value_matrix[n_points_1d][stencil_edge];
    double derivative_matrix[n_points_1d][stencil_edge];

    static int
    number_in_block(const Index<dim> &corner);
  };
} // namespace magmpm
