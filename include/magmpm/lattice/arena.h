#pragma once

#include <magmpm/lattice/node_field.h>
#include <magmpm/lattice/node_window.h>

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

    /**
     * Adds the arena of the block in @p slot to a field of up to four lanes; all blocks around it must
     * be active.
     */
    template <typename Quantities>
    void
    add_to(NodeField<dim, Quantities> &field, const BlockSet<dim> &blocks, const int slot) const
    {
      constexpr int width = NodeField<dim, Quantities>::width;
      static_assert(width <= n_lanes, "there is room for four lanes");
      for_each_segment(blocks.neighbours(slot),
                       [&](const int from, const int in, const int node, const auto n_nodes) {
                         double *target       = field.block(in) + node * width;
                         const double *source = values + from * n_lanes;
                         if constexpr (width == n_lanes)
                           for (int i = 0; i < n_nodes * n_lanes; ++i)
                             target[i] += source[i];
                         else
                           for (int i = 0; i < n_nodes; ++i)
                             for (int lane = 0; lane < width; ++lane)
                               target[i * width + lane] += source[i * n_lanes + lane];
                       });
    }

    /** Fills the arena of the block in @p slot from such a field; lanes that it has not become zero. */
    template <typename Quantities>
    void
    load(const NodeField<dim, Quantities> &field, const BlockSet<dim> &blocks, const int slot)
    {
      constexpr int width = NodeField<dim, Quantities>::width;
      static_assert(width <= n_lanes, "there is room for four lanes");
      if constexpr (width < n_lanes)
        set_zero();
      for_each_segment(blocks.neighbours(slot),
                       [&](const int to, const int in, const int node, const auto n_nodes) {
                         double *target       = values + to * n_lanes;
                         const double *source = field.block(in) + node * width;
                         if constexpr (width == n_lanes)
                           std::memcpy(target, source, n_nodes * n_lanes * sizeof(double));
                         else
                           for (int i = 0; i < n_nodes; ++i)
                             std::copy_n(source + i * width, width, target + i * n_lanes);
                       });
    }

  private:
    template <int n>
    using Nodes = std::integral_constant<int, n>;

    /**
     * Calls f(node of the arena, slot, node in its block, number of nodes) for all pieces of rows of
     * nodes. A row of 8 nodes along x lies in three blocks: 1, 4 and 3 nodes of them. Their numbers are
     * constants of the compiler.
     */
    template <typename Function>
    static void
    for_each_segment(const std::array<int, n_neighbours<dim>> &neighbours, const Function &f)
    {
      using Window         = NodeWindow<dim, 1, edge - block_edge - 1>;
      constexpr int n_rows = power(edge, dim - 1);
      for (int row = 0; row < n_rows; ++row)
        {
          const int first        = row * edge;
          const NodePlace &below = Window::place(first);
          const NodePlace &own   = Window::place(first + 1);
          const NodePlace &above = Window::place(first + 1 + block_edge);
          f(first, neighbours[below.neighbour], below.node, Nodes<1>());
          f(first + 1, neighbours[own.neighbour], own.node, Nodes<block_edge>());
          f(first + 1 + block_edge,
            neighbours[above.neighbour],
            above.node,
            Nodes<edge - block_edge - 1>());
        }
    }

    alignas(64) double values[n_nodes * n_lanes];
  };
} // namespace magmpm
