#pragma once

#include <magmpm/boundary/wall_parameters.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/lattice.h>

#include <utility>
#include <vector>

/** A box with equal edges and its blocks, on one rank. */
namespace magmpm::testing
{
  template <int dim>
  Lattice<dim>
  cube_lattice(const int n_cells, const double spacing)
  {
    Lattice<dim> lattice;
    lattice.spacing = spacing;
    lattice.n_cells.fill(n_cells);
    return lattice;
  }

  /** @param n_around  blocks beyond the box on each side. */
  template <int dim>
  BlockSet<dim>
  blocks_of_cube(const int n_cells, const int n_around = 0)
  {
    std::vector<Index<dim>> blocks;
    const int n = n_cells / block_edge + 2 * n_around;
    for (int i = 0; i < power(n, dim); ++i)
      {
        Index<dim> block;
        for (int d = 0, rest = i; d < dim; ++d, rest /= n)
          block[d] = rest % n - n_around;
        blocks.push_back(block);
      }
    return BlockSet<dim>(std::move(blocks), power(n, dim));
  }

  template <int dim>
  WallParameters<dim>
  all_walls(const WallCondition condition, const double friction = 0.)
  {
    WallParameters<dim> walls;
    walls.condition.fill(condition);
    walls.friction.fill(friction);
    return walls;
  }
} // namespace magmpm::testing
