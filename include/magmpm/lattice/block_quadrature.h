#pragma once

#include <magmpm/lattice/node_window.h>

#include <array>

namespace magmpm
{
  /**
   * The points of QGauss(3) in all cells of edge dx of a block, and quadratic B-splines evaluated there and
   * integrated over the block: what CellQuadrature does for one cell, for 4^dim cells at once and in
   * registers full of points. In 3D the points are worked on in planes across z, so that all that is in hand
   * fits into the first-level cache; in 2D there is one plane.
   */
  template <int dim>
  class BlockQuadrature
  {
  public:
    /** Nodes whose B-splines reach into the block: -1 .. 5 along each axis, x fastest. */
    using Window = NodeWindow<dim, 1, 2>;

    /** A number on each of these nodes. */
    using NodeValues = std::array<double, Window::n_nodes>;

    static constexpr int points_1d = 3 * block_edge;
    static constexpr int n_planes  = power(points_1d, dim - 2);
    static constexpr int plane     = points_1d * points_1d; ///< points in it, x fastest

    /** A number on each point of a plane. */
    struct alignas(64) PlaneValues : public std::array<double, plane>
    {
    };

    using PlaneGradients = std::array<PlaneValues, dim>;

    BlockQuadrature();

    /** Sum_i N_i v_i at the points of a plane. */
    void
    interpolate(const NodeValues &nodes, const int number, PlaneValues &values) const;

    /** The same, and sum_i v_i grad N_i, in units of 1/dx. */
    void
    interpolate(const NodeValues &nodes,
                const int number,
                PlaneValues &values,
                PlaneGradients &gradients) const;

    /** Adds sum_q F_q . grad N_i for every node, in units of 1/dx: the transpose of the gradient. */
    void
    add_tested_by_gradient(const PlaneGradients &fluxes, const int number, NodeValues &nodes) const;

    /** Coordinate of points along an axis, from the lower corner of the block, in dx. */
    const std::array<double, points_1d> &
    coordinates() const
    {
      return points;
    }

    /** Weights along an axis; those of a point are products, and sum to 4^dim, in dx^dim. */
    const std::array<double, points_1d> &
    weights_1d() const
    {
      return weights;
    }

  private:
    static constexpr int edge = Window::edge;

    /** Numbers on the nodes of a plane across z, with rows of one place more than there are nodes. */
    static constexpr int row = 8;
    using PlaneNodes         = std::array<double, edge * row>;

    /** Sum over planes of nodes, for the points of plane @p number: with N or with dN/dz. */
    template <bool derivative>
    void
    across(const NodeValues &nodes, const int number, PlaneNodes &result) const;

    std::array<double, points_1d> points, weights;
    std::array<int, points_1d> bases; ///< of the three nodes around a point, in the window
    double value[points_1d][3], derivative[points_1d][3];

    /** The same as full matrices, [node][point]. */
    alignas(64) double value_matrix[edge][points_1d];
    alignas(64) double derivative_matrix[edge][points_1d];

    /** Transposed, [point][node]. */
    alignas(64) double value_rows[points_1d][row];
    alignas(64) double derivative_rows[points_1d][row];
  };
} // namespace magmpm
