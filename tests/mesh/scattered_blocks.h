#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/parallel/ranks.h>

#include <vector>

/** Bodies made of blocks, spread over the ranks in every way. */
namespace magmpm::testing
{
  inline unsigned int
  this_rank()
  {
    return parallel::rank(MPI_COMM_WORLD);
  }

  inline unsigned int
  n_ranks()
  {
    return parallel::n_ranks(MPI_COMM_WORLD);
  }

  template <int dim>
  Lattice<dim>
  lattice_of_blocks(const Index<dim> &n_blocks)
  {
    Lattice<dim> lattice;
    lattice.spacing = 0.01;
    for (int d = 0; d < dim; ++d)
      {
        lattice.lower_corner[d] = -0.3 + 0.1 * d;
        lattice.n_cells[d]      = block_edge * n_blocks[d];
      }
    return lattice;
  }

  /** The same number in all directions. */
  template <int dim>
  Index<dim>
  uniform_index(const int value)
  {
    Index<dim> index;
    index.fill(value);
    return index;
  }

  /** All blocks from @p lower to @p upper, the latter not included. */
  template <int dim>
  std::vector<Index<dim>>
  box_of_blocks(const Index<dim> &lower, const Index<dim> &upper)
  {
    std::vector<Index<dim>> blocks(1, lower);
    for (int d = 0; d < dim; ++d)
      for (std::size_t b = 0; b < blocks.size(); ++b)
        if (blocks[b][d] + 1 < upper[d])
          {
            blocks.push_back(blocks[b]);
            ++blocks.back()[d];
          }
    return blocks;
  }

  /** Every n-th of them, different ones on each of the n ranks: as particles lie before migration. */
  template <int dim>
  std::vector<Index<dim>>
  dealt_out(const std::vector<Index<dim>> &blocks)
  {
    std::vector<Index<dim>> mine;
    for (std::size_t b = this_rank(); b < blocks.size(); b += n_ranks())
      mine.push_back(blocks[b]);
    return mine;
  }

  /** Those of the blocks that this rank owns. */
  template <int dim, typename Mesh>
  std::vector<Index<dim>>
  owned_of(const std::vector<Index<dim>> &blocks, const Mesh &mesh)
  {
    const std::vector<unsigned int> owners = mesh.owners(blocks);
    std::vector<Index<dim>> mine;
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (owners[b] == this_rank())
        mine.push_back(blocks[b]);
    return mine;
  }
} // namespace magmpm::testing
