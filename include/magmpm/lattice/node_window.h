#pragma once

#include <magmpm/lattice/block_set.h>

namespace magmpm
{
  /** Where a node lies, seen from a block. */
  struct NodePlace
  {
    int neighbour; ///< the block that holds it, as in BlockSet::neighbours()
    int node;      ///< its number in that block
  };

  /** The table of NodeWindow: for a loop at compile time, which a class cannot run on itself. */
  template <int dim, int lower, int upper>
  constexpr std::array<NodePlace, power(lower + block_edge + upper, dim)>
  make_window_places()
  {
    std::array<NodePlace, power(lower + block_edge + upper, dim)> places = {};
    for (std::size_t i = 0; i < places.size(); ++i)
      {
        int rest = static_cast<int>(i);
        for (int d = 0; d < dim; ++d)
          {
            const int node = rest % (lower + block_edge + upper) - lower + block_edge; // from below
            places[i].neighbour += power(3, d) * (node / block_edge);
            places[i].node += power(block_edge, d) * (node % block_edge);
            rest /= lower + block_edge + upper;
          }
      }
    return places;
  }

  /**
   * The nodes of a block, @p lower nodes below and @p upper above it along each axis, x fastest: which
   * block around holds each of them, and as which of its nodes. What looks beyond a block (arenas,
   * stencils of cells, filters, images behind walls) looks through such a window.
   */
  template <int dim, int lower, int upper>
  class NodeWindow
  {
  public:
    static_assert(0 <= lower && lower <= block_edge && 0 <= upper && upper <= block_edge,
                  "a window reaches the blocks around, not further");

    static constexpr int edge    = lower + block_edge + upper;
    static constexpr int n_nodes = power(edge, dim);

    /** Distance in the window between neighbours along an axis. */
    static constexpr int
    stride(const int axis)
    {
      return power(edge, axis);
    }

    static constexpr const NodePlace &
    place(const int i)
    {
      return places[i];
    }

    /** The place in the window of node @p node of the block itself (0 .. 4^dim - 1). */
    static constexpr int
    of_block(int node)
    {
      int i = 0;
      for (int d = 0; d < dim; ++d, node /= block_edge)
        i += stride(d) * (node % block_edge + lower);
      return i;
    }

    /** From the first of @p width^dim nodes in a box to each of them, x fastest. */
    template <int width>
    static constexpr std::array<int, power(width, dim)>
    box_offsets()
    {
      std::array<int, power(width, dim)> offsets = {};
      for (std::size_t i = 0; i < offsets.size(); ++i)
        {
          int rest = static_cast<int>(i);
          for (int d = 0; d < dim; ++d, rest /= width)
            offsets[i] += stride(d) * (rest % width);
        }
      return offsets;
    }

  private:
    static constexpr auto places = make_window_places<dim, lower, upper>();
  };

  /** Calls f(slot, node) for all nodes of the owned blocks. */
  template <int dim, typename Function>
  inline void
  for_nodes(const BlockSet<dim> &blocks, const Function &f)
  {
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      for (int node = 0; node < nodes_per_block<dim>; ++node)
        f(slot, node);
  }

  /** The same for those of ghost blocks too. */
  template <int dim, typename Function>
  inline void
  for_nodes_and_ghosts(const BlockSet<dim> &blocks, const Function &f)
  {
    for (int slot = 0; slot < blocks.size(); ++slot)
      for (int node = 0; node < nodes_per_block<dim>; ++node)
        f(slot, node);
  }

  /** Whether f(slot, node) for any of the active ones of the 3^dim nodes around a node, itself included. */
  template <int dim, typename Predicate>
  inline bool
  any_node_around(const BlockSet<dim> &blocks, const int slot, const int node, const Predicate &f)
  {
    using Window           = NodeWindow<dim, 1, 1>;
    constexpr auto offsets = Window::template box_offsets<3>();
    const int first        = Window::of_block(node) - offsets[n_neighbours<dim> / 2];
    for (const int offset : offsets)
      {
        const NodePlace &place = Window::place(first + offset);
        const int other        = blocks.neighbours(slot)[place.neighbour];
        if (other != invalid_slot && f(other, place.node))
          return true;
      }
    return false;
  }

  /** Calls f(slot, node) for all of them. */
  template <int dim, typename Function>
  inline void
  for_nodes_around(const BlockSet<dim> &blocks, const int slot, const int node, const Function &f)
  {
    any_node_around(blocks, slot, node, [&f](const int other, const int number) {
      f(other, number);
      return false;
    });
  }
} // namespace magmpm
