#pragma once

#include <magmpm/lattice/block_set.h>

namespace magmpm
{
  /** A node of the active blocks. */
  struct LatticeNode
  {
    int slot;   ///< or invalid_slot
    int number; ///< in the block, 0 .. 4^dim - 1
  };

  /** Where the node @p index, an integer vector of the lattice, is. */
  template <int dim>
  inline LatticeNode
  lattice_node(const BlockSet<dim> &blocks, const Index<dim> &index)
  {
    const Index<dim> block = block_of<dim>(index);
    int number             = 0;
    for (int d = dim - 1; d >= 0; --d)
      number = block_edge * number + index[d] - block_edge * block[d];
    return {blocks.slot(block), number};
  }
} // namespace magmpm
