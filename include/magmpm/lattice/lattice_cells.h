#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/cell_stencil.h>

#include <array>
#include <cmath>
#include <vector>

namespace magmpm
{
  /**
   * Cells of one edge on the lattice, in which node fields are integrated: where each lies among the
   * blocks, and the quadrature points that all of them share (CellStencil). Cells outside of owned active
   * blocks are in the list, but have no slot.
   */
  template <int dim>
  class LatticeCells
  {
  public:
    /** @param cell_edge  in dx: 2 or 1. */
    LatticeCells(const Lattice<dim> &lattice, const int cell_edge)
      : lattice(lattice)
      , the_stencil(cell_edge)
    {
      const double half_edge = 0.5 * cell_edge * lattice.spacing;
      for (int q = 0; q < n_points<dim>; ++q)
        {
          weights[q] = 1.;
          for (int d = 0, rest = q; d < dim; ++d, rest /= n_points_1d)
            {
              weights[q] *= half_edge * CellStencil<dim>::weights_1d[rest % n_points_1d];
              offsets[q][d] = half_edge * CellStencil<dim>::points_1d[rest % n_points_1d];
            }
        }
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

    /** The quadrature point @p q (0 .. n_points - 1) of a cell [m]. */
    Vector<dim>
    point(const unsigned int cell, const int q) const
    {
      return cells[cell].position + offsets[q];
    }

    /** Of the quadrature point @p q of every cell; they sum to a cell [m^dim]. */
    double
    weight(const int q) const
    {
      return weights[q];
    }

    /** Reads the nodes around a cell; nodes of blocks that are not active count as zero. */
    void
    gather(const NodeNumbers<dim> &field, const unsigned int cell, StencilValues<dim> &values) const
    {
      the_stencil.gather(field, *the_blocks, cells[cell].slot, cells[cell].corner, values);
    }

    /** Adds to the nodes around a cell, apart from those of blocks that are not active. */
    void
    scatter_add(const StencilValues<dim> &values,
                const unsigned int cell,
                NodeNumbers<dim> &field) const
    {
      the_stencil.scatter_add(values, *the_blocks, cells[cell].slot, cells[cell].corner, field);
    }

    const CellStencil<dim> &
    stencil() const
    {
      return the_stencil;
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
    const CellStencil<dim> the_stencil;
    const BlockSet<dim> *the_blocks = nullptr;
    std::vector<Cell> cells;

    std::array<double, n_points<dim>> weights;
    std::array<Vector<dim>, n_points<dim>> offsets; ///< from the lower node of a cell [m]
  };
} // namespace magmpm
