#pragma once

#include <magmpm/mesh/block_partition.h>

namespace magmpm
{
  /**
   * Filters over the 3^dim nodes around each node, for the material indicator. All of them act on all
   * lanes, as on scalars, take ghosts that are up to date and leave them so, with the images behind
   * shielded walls, and are collective. Nodes of blocks that are not active count as zero.
   */

  /**
   * Undoes, to second order, the smear of two passes of quadratic B-splines (P2G and interpolation),
   * whose variance is dx^2/4 each and axis: v <- v - dx^2/4 Laplace_h v.
   */
  template <int dim>
  void
  remove_smear(const BlockPartition<dim> &partition, NodeNumbers<dim> &field);

  /** The largest value of the 3^dim nodes around. */
  template <int dim>
  void
  maximize(const BlockPartition<dim> &partition, NodeNumbers<dim> &field);

  /**
   * (1/4, 1/2, 1/4) along each axis. Where a node around is not active its share stays, so that the
   * filter is symmetric and keeps constants and sums, exactly.
   */
  template <int dim>
  void
  smooth(const BlockPartition<dim> &partition, NodeNumbers<dim> &field);
} // namespace magmpm
