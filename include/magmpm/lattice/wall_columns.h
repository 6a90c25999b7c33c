#pragma once

#include <magmpm/lattice/lattice_node.h>

namespace magmpm
{
  /**
   * The nodes of a line across a wall of the box: one on the wall, those in front of it, where material is,
   * and their mirror images behind it.
   */
  class WallColumn
  {
  public:
    /**
     * @param at_wall  the node on the wall, the first of its block along the axis.
     * @param below    the block below along the axis.
     * @param stride   between the numbers of neighbours along the axis.
     */
    WallColumn(const LatticeNode &at_wall, const int below, const int stride, const bool is_lower)
      : at_wall(at_wall)
      , below(below)
      , stride(stride)
      , is_lower(is_lower)
    {
    }

    LatticeNode
    on_wall() const
    {
      return at_wall;
    }

    /** @param distance  from the wall, 1 .. 3 nodes. */
    LatticeNode
    in_front(const int distance) const
    {
      return is_lower ? node_above(distance) : node_below(distance);
    }

    LatticeNode
    behind(const int distance) const
    {
      return is_lower ? node_below(distance) : node_above(distance);
    }

  private:
    LatticeNode
    node_above(const int distance) const
    {
      return {at_wall.slot, at_wall.number + distance * stride};
    }

    LatticeNode
    node_below(const int distance) const
    {
      return {below, at_wall.number + (block_edge - distance) * stride};
    }

    LatticeNode at_wall;
    int below, stride;
    bool is_lower;
  };

  /**
   * Calls f(column) for all columns across a face of the box of which the nodes are active.
   *
   * @param n_slots  the blocks with the nodes on the wall: blocks.n_owned() for owned ones, or blocks.size().
   * @param n_cells  of the box.
   */
  template <int dim, typename Function>
  void
  for_wall_columns(const BlockSet<dim> &blocks,
                   const int n_slots,
                   const Index<dim> &n_cells,
                   const int face,
                   const Function &f)
  {
    const int axis      = face / 2;
    const int stride    = power(block_edge, axis);
    const bool is_lower = (face % 2 == 0);
    const int wall      = (is_lower ? 0 : n_cells[axis]);
    for (int slot = 0; slot < n_slots; ++slot)
      {
        if (block_edge * blocks.block(slot)[axis] != wall)
          continue;
        const int below = blocks.neighbours(slot)[n_neighbours<dim> / 2 - power(3, axis)];
        if (below == invalid_slot)
          continue;
        for (int n = 0; n < nodes_per_block<dim>; ++n)
          if (n / stride % block_edge == 0)
            f(WallColumn({slot, n}, below, stride, is_lower));
      }
  }
} // namespace magmpm
