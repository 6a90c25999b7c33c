#pragma once

#include <magmpm/base/tensor.h>

#include <array>
#include <cmath>

namespace magmpm
{
  /** An integer vector: a lattice node, a cell or a block. */
  template <int dim>
  using Index = std::array<int, dim>;

  constexpr int
  power(const int base, const int exponent)
  {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
  }

  /** Lattice cells along an edge of a block, the unit of storage, work and ownership. */
  inline constexpr int block_edge = 4;

  /** Numbers stored on a node of a NodeField: one SIMD register of doubles. */
  inline constexpr int n_lanes = 4;

  template <int dim>
  inline constexpr int nodes_per_block = power(block_edge, dim);

  /** The block that holds a node or cell: floor(index / block_edge) in every direction. */
  template <int dim>
  inline Index<dim>
  block_of(const Index<dim> &index)
  {
    static_assert(block_edge == 4, "the shift below is a division by 4 that rounds down");
    Index<dim> block;
    for (int d = 0; d < dim; ++d)
      block[d] = index[d] >> 2;
    return block;
  }

  /** The number of a node in its block: 0 .. 4^dim - 1, x fastest. */
  template <int dim>
  inline int
  number_in_block(const Index<dim> &node)
  {
    int number = 0;
    for (int d = dim - 1; d >= 0; --d)
      number = block_edge * number + (node[d] & (block_edge - 1));
    return number;
  }

  /**
   * The lattice of the material point method: nodes with spacing dx, counted from the lower corner
   * of the mechanical box (the walls); negative outside.
   */
  template <int dim>
  struct Lattice
  {
    Vector<dim> lower_corner; ///< of the mechanical box [m]
    double spacing     = 0.;  ///< dx [m]
    Index<dim> n_cells = {};  ///< of the mechanical box; multiples of block_edge

    Vector<dim>
    node_position(const Index<dim> &node) const
    {
      Vector<dim> position = lower_corner;
      for (int d = 0; d < dim; ++d)
        position[d] += spacing * node[d];
      return position;
    }

    /** Position in units of dx, from the lower corner. */
    Vector<dim>
    reduced(const Vector<dim> &position) const
    {
      return (1. / spacing) * (position - lower_corner);
    }

    /** Lower corner of the 3^dim nodes whose quadratic B-splines reach @p position. */
    Index<dim>
    base_node(const Vector<dim> &position) const
    {
      const Vector<dim> x = reduced(position);
      Index<dim> node;
      for (int d = 0; d < dim; ++d)
        node[d] = static_cast<int>(std::floor(x[d] - 0.5));
      return node;
    }

    /** The lattice node closest to @p position. */
    Index<dim>
    nearest_node(const Vector<dim> &position) const
    {
      const Vector<dim> x = reduced(position);
      Index<dim> node;
      for (int d = 0; d < dim; ++d)
        node[d] = static_cast<int>(std::lround(x[d]));
      return node;
    }

    Vector<dim>
    upper_corner() const
    {
      return node_position(n_cells);
    }
  };
} // namespace magmpm
