#pragma once

#include <magmpm/lattice/node_field.h>

#include <array>

namespace magmpm
{
  /** How the image of a quantity behind a wall follows from what stands in front of it. */
  struct Parity
  {
    enum Sign
    {
      even,      ///< the same
      odd,       ///< turned around, and zero on the wall
      odd_normal ///< of a vector, the component along the wall's normal is odd, the others are even
    };

    /** Those of a mirror; a wall at which material sticks makes velocities odd, masses even. */
    Sign scalars = even;
    Sign vectors = odd_normal;
  };

  /** Walls of the mechanical box that are mirrors: -x, +x, -y, ... */
  template <int dim>
  struct MirrorWalls
  {
    std::array<bool, 2 *dim> is_mirror = {};
    Index<dim> n_cells                 = {}; ///< of the mechanical box
  };

  /**
   * Adds the images of material behind walls to a node field that P2G, or quadrature, made of the
   * material in front: c_i <- c_i + R c_(-i), i counted from the wall. Without them a body that touches
   * such a wall would fade out before it, with magnetic poles there. Particles reach one node behind a
   * wall, so nodes -1, 0, 1 change; nodes -2 and -3 become images of 2 and 3.
   *
   * BlockPartition::add_ghosts_to_owners() does it on its way for shielded walls, on owned nodes: there
   * blocks behind a wall have the owner of the one in front of it. At other walls it is to be done
   * before, on owned nodes and ghosts: what the particles of a rank give both is on that rank.
   *
   * @param n_slots  slots of the field that it is done in: blocks.n_owned(), or blocks.size().
   */
  template <int dim>
  void
  add_images(const BlockSet<dim> &blocks,
             const int n_slots,
             const MirrorWalls<dim> &walls,
             const Parity &parity,
             NodeNumbers<dim> &field);

  /**
   * Makes nodes -1, -2, -3 images of 1, 2, 3; what is odd becomes zero on the wall.
   *
   * BlockPartition::update_ghosts() does it on its way for shielded walls, on owned nodes. At other
   * walls it is to be done afterwards, on owned nodes and ghosts.
   */
  template <int dim>
  void
  copy_images(const BlockSet<dim> &blocks,
              const int n_slots,
              const MirrorWalls<dim> &walls,
              const Parity &parity,
              NodeNumbers<dim> &field);
} // namespace magmpm
