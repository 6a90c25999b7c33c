#pragma once

#include <magmpm/lattice/block_set.h>

#include <algorithm>
#include <vector>

namespace magmpm
{
  /**
   * Four numbers on every node of the active blocks: by slot, then by node (x fastest), then by
   * lane. What the lanes mean is said where a field is declared; momentum and mass, for example, are
   * {p_x, p_y, p_z, m} (p_z unused in 2D).
   */
  template <int dim>
  class NodeField
  {
  public:
    static constexpr int block_size = nodes_per_block<dim> * n_lanes;

    /** Makes room for @p n_blocks blocks and sets all values to zero. */
    void
    reinit(const int n_blocks)
    {
      values.assign(static_cast<std::size_t>(n_blocks) * block_size, 0.);
    }

    void
    set_zero()
    {
      std::fill(values.begin(), values.end(), 0.);
    }

    int
    n_blocks() const
    {
      return static_cast<int>(values.size() / block_size);
    }

    /** The first value of the block in @p slot. */
    double *
    block(const int slot)
    {
      return values.data() + static_cast<std::size_t>(slot) * block_size;
    }

    const double *
    block(const int slot) const
    {
      return values.data() + static_cast<std::size_t>(slot) * block_size;
    }

    /** The four lanes of node @p node (0 .. 4^dim - 1, x fastest) in @p slot. */
    double *
    node(const int slot, const int node)
    {
      return block(slot) + node * n_lanes;
    }

    const double *
    node(const int slot, const int node) const
    {
      return block(slot) + node * n_lanes;
    }

  private:
    std::vector<double> values;
  };

  /** The node number @p number of @p block as an integer vector of the lattice. */
  template <int dim>
  inline Index<dim>
  node_of_block(const Index<dim> &block, int number)
  {
    Index<dim> node;
    for (int d = 0; d < dim; ++d, number /= block_edge)
      node[d] = block_edge * block[d] + number % block_edge;
    return node;
  }
} // namespace magmpm
