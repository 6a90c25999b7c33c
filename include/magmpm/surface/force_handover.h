#pragma once

#include <magmpm/mesh/block_partition.h>

namespace magmpm
{
  /**
   * Moves force that falls on nodes without mass to nodes with mass: the outer of two layers first, in
   * equal parts to the neighbours (3^dim) in the next inner layer. Conserves the sum over these nodes
   * exactly, on any number of ranks.
   *
   * @param mass   [kg], ghosts updated.
   * @param force  [N] on owned nodes, ghosts zero; afterwards zero where no mass is.
   * @return this rank's part of the force on nodes further out, which is dropped [N]. Collective.
   */
  template <int dim>
  Vector<dim>
  hand_force_inward(const BlockPartition<dim> &partition,
                    const NodeField<dim, SingleScalar> &mass,
                    NodeField<dim, SingleVector> &force);
} // namespace magmpm
