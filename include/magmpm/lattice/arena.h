#pragma once

#include <magmpm/lattice/node_field.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace magmpm
{
  /**
   * A dense copy of the nodes that the particles of one block can reach: 8^dim nodes around the
   * block, from one below its first node. That leaves room for particles that drifted by up to one
   * cell since they were sorted into the block. Small enough for the first-level cache.
   */
  template <int dim>
  class Arena
  {
  public:
    static constexpr int edge    = 2 * block_edge;
    static constexpr int n_nodes = power(edge, dim);

    /** Distance in doubles between neighbouring nodes in direction @p d. */
    static constexpr int
    stride(const int d)
    {
      return n_lanes * power(edge, d);
    }

    /** The lattice node in the lower corner of the arena of @p block. */
    static Index<dim>
    first_node(const Index<dim> &block)
    {
      Index<dim> node;
      for (int d = 0; d < dim; ++d)
        node[d] = block_edge * block[d] - 1;
      return node;
    }

    void
    set_zero()
    {
      std::fill(values, values + n_nodes * n_lanes, 0.);
    }

    double *
    data()
    {
      return values;
    }

    const double *
    data() const
    {
      return values;
    }

    /** Adds the arena of the block in @p slot to a field; all blocks around it must be active. */
    void
    add_to(NodeField<dim> &field, const BlockSet<dim> &blocks, const int slot) const
    {
      for_each_segment(blocks.neighbours(slot),
                       [&](const int from, const int in, const int offset, const auto length) {
                         double *target       = field.block(in) + offset;
                         const double *source = values + from;
                         for (int i = 0; i < length; ++i)
                           target[i] += source[i];
                       });
    }

    /** Fills the arena of the block in @p slot from a field. */
    void
    load(const NodeField<dim> &field, const BlockSet<dim> &blocks, const int slot)
    {
      for_each_segment(blocks.neighbours(slot),
                       [&](const int to, const int in, const int offset, const auto length) {
                         std::memcpy(
                           values + to, field.block(in) + offset, length * sizeof(double));
                       });
    }

  private:
    template <int n>
    using Doubles = std::integral_constant<int, n>;

    /**
     * Calls f(place in the arena, slot, place in its block, length) for all pieces of rows of nodes,
     * in doubles. A row of 8 nodes along x lies in three blocks: 1, 4 and 3 nodes of them. Lengths are
     * constants of the compiler.
     */
    template <typename Function>
    static void
    for_each_segment(const std::array<int, n_neighbours<dim>> &neighbours, const Function &f)
    {
      constexpr int n_rows = power(edge, dim - 1);
      for (int row = 0; row < n_rows; ++row)
        {
          int neighbour = 0, node = 0;
          for (int d = 1, rest = row; d < dim; ++d, rest /= edge)
            {
              const int position = rest % edge + block_edge - 1; // from the block below
              neighbour += power(3, d) * (position / block_edge);
              node += power(block_edge, d) * (position % block_edge);
            }
          const int first = row * edge * n_lanes;
          node *= n_lanes;
          f(first, neighbours[neighbour], node + 3 * n_lanes, Doubles<n_lanes>());
          f(first + n_lanes, neighbours[neighbour + 1], node, Doubles<4 * n_lanes>());
          f(first + 5 * n_lanes, neighbours[neighbour + 2], node, Doubles<3 * n_lanes>());
        }
    }

    alignas(64) double values[n_nodes * n_lanes];
  };
} // namespace magmpm
