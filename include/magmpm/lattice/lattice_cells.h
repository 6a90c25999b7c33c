#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/cell_quadrature.h>

#include <vector>

namespace magmpm
{
  /**
   * Mesh cells of one edge on the lattice, in which node fields are integrated: where each lies among the
   * blocks. Cells outside of owned active blocks are in the list, but have no slot.
   */
  template <int dim>
  class LatticeCells
  {
  public:
    /** @param cell_edge  in dx: 2 or 1. */
    LatticeCells(const Lattice<dim> &lattice, const int cell_edge)
      : lattice(lattice)
      , cell_edge(cell_edge)
    {
    }

    /** @param blocks  must stay as they are. */
    void
    reinit(const std::vector<Index<dim>> &lower_nodes, const BlockSet<dim> &blocks)
    {
      the_blocks = &blocks;
      cells.assign(lower_nodes.size(), Cell());
      for (std::size_t c = 0; c < cells.size(); ++c)
        {
          const Index<dim> block = block_of<dim>(lower_nodes[c]);
          const int slot         = blocks.slot(block);
          if (slot == invalid_slot || slot >= blocks.n_owned())
            continue;
          cells[c].slot     = slot;
          cells[c].position = lattice.node_position(lower_nodes[c]);
          for (int d = 0; d < dim; ++d)
            cells[c].corner[d] = lower_nodes[c][d] - block_edge * block[d];
        }
    }

    /** A rule for these cells, of n points per axis. */
    template <int n>
    CellQuadrature<dim, n>
    quadrature() const
    {
      return CellQuadrature<dim, n>(cell_edge, lattice.spacing);
    }

    unsigned int
    size() const
    {
      return static_cast<unsigned int>(cells.size());
    }

    /** Whether a cell lies in an owned active block: only then has it what follows. */
    bool
    is_active(const unsigned int cell) const
    {
      return cells[cell].slot != invalid_slot;
    }

    /** The lower node of a cell [m]: points of a rule lie from there. */
    const Vector<dim> &
    position(const unsigned int cell) const
    {
      return cells[cell].position;
    }

    /** Reads the nodes around a cell; nodes of blocks that are not active count as zero. */
    void
    gather(const NodeNumbers<dim> &field, const unsigned int cell, StencilValues<dim> &values) const
    {
      gather_stencil<dim>(field, *the_blocks, cells[cell].slot, cells[cell].corner, values);
    }

    /** Adds to the nodes around a cell, apart from those of blocks that are not active. */
    void
    scatter_add(const StencilValues<dim> &values,
                const unsigned int cell,
                NodeNumbers<dim> &field) const
    {
      scatter_stencil<dim>(values, *the_blocks, cells[cell].slot, cells[cell].corner, field);
    }

    double
    spacing() const
    {
      return lattice.spacing;
    }

  private:
    struct Cell
    {
      int slot = invalid_slot; ///< of its block
      Index<dim> corner;       ///< its lower node in the block
      Vector<dim> position;    ///< of the lower node [m]
    };

    const Lattice<dim> lattice;
    const int cell_edge;
    const BlockSet<dim> *the_blocks = nullptr;
    std::vector<Cell> cells;
  };
} // namespace magmpm
