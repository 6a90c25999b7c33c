#pragma once

#include <magmpm/mesh/block_partition.h>

#include <array>

namespace magmpm
{
  /**
   * Adds the images of material behind shielded walls to a node field that P2G made of the material in
   * front: c_i <- c_i + c_(-i), i counted from the wall. Without them a body that touches such a wall
   * would fade out before it, with magnetic poles there. Particles reach one node behind a wall, so
   * nodes -1, 0, 1 change; nodes -2 and -3 become copies of 2 and 3. All four lanes; ghosts up to date
   * before and after. Collective.
   *
   * @param shielded  walls -x, +x, -y, ... of the mechanical box, at which the potential box ends.
   */
  template <int dim>
  void
  add_mirror_images(const BlockPartition<dim> &partition,
                    const Lattice<dim> &lattice,
                    const std::array<bool, 2 * dim> &shielded,
                    NodeField<dim> &content);

  /** Copies nodes 1, 2, 3 in front of shielded walls to -1, -2, -3; else as add_mirror_images(). */
  template <int dim>
  void
  copy_mirror_images(const BlockPartition<dim> &partition,
                     const Lattice<dim> &lattice,
                     const std::array<bool, 2 * dim> &shielded,
                     NodeField<dim> &field);

  /**
   * The same for the first dim lanes as a vector, of which a mirror turns the component along its normal
   * around: f_i <- f_i + R f_(-i). That component is zero on the wall. Forces that were integrated over
   * the near side of the wall become those of material on both sides.
   *
   * @param field  ghosts zero, before and after.
   */
  template <int dim>
  void
  add_mirror_images_of_vector(const BlockPartition<dim> &partition,
                              const Lattice<dim> &lattice,
                              const std::array<bool, 2 * dim> &shielded,
                              NodeField<dim> &field);
} // namespace magmpm
