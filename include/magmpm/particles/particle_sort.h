#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /** Blocks and the number of particles in each. */
  template <int dim>
  struct OccupiedBlocks
  {
    std::vector<Index<dim>> blocks; ///< sorted
    std::vector<unsigned int> n_particles;
  };

  /**
   * The blocks of the base nodes of this rank's particles.
   *
   * @param with_force_margin  also, with no particles of their own, the blocks one node further up in
   *                           all directions from magnetic particles. A base node has mass up to two
   *                           nodes above it, magnetic force is handed in from two more, and the
   *                           B-spline of the last of these reaches one cell further: with the blocks
   *                           around all of these active, every such node sees all its cells.
   */
  template <int dim>
  OccupiedBlocks<dim>
  occupied_blocks(const std::vector<Body<dim>> &bodies,
                  const Lattice<dim> &lattice,
                  const bool with_force_margin = false);

  /**
   * The blocks of the base nodes that particles will have in @p time [s] if they fly on as they do, and
   * of those on the way, four cells apart at most. For the mesh, which looks ahead.
   *
   * @param with_force_margin  as above.
   */
  template <int dim>
  std::vector<Index<dim>>
  approached_blocks(const std::vector<Body<dim>> &bodies,
                    const Lattice<dim> &lattice,
                    const double time,
                    const bool with_force_margin = false);

  /**
   * Brings the particles of a body into the order of the blocks' slots, within a block into that of
   * the cells, and notes the runs. All particles must lie in owned blocks.
   */
  template <int dim>
  void
  sort_into_blocks(const BlockSet<dim> &blocks, const Lattice<dim> &lattice, Body<dim> &body);
} // namespace magmpm
