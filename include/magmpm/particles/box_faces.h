#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/particles/body.h>

#include <array>
#include <cstdint>
#include <vector>

namespace magmpm
{
  /** Which faces of the box particles may pass, in the order -x, +x, -y, +y, -z, +z. */
  template <int dim>
  using OpenFaces = std::array<bool, 2 * dim>;

  /** How deep particles of solids may lie behind walls, which press on them by how deep they are, in dx. */
  inline constexpr double tolerated_depth_of_solids = 0.5;

  /**
   * Puts particles that a step took through a wall, a face that is not open, back onto it, and takes
   * from them the part of their velocity that goes into it: the wall takes up that momentum. Those of
   * solids may lie behind it, to tolerated_depth_of_solids.
   *
   * The lattice alone does not hold them: its velocity at the wall is an average over nodes on both
   * sides, one of which moves.
   *
   * @return how many.
   */
  template <int dim>
  std::size_t
  hold_at_walls(const BlockSet<dim> &blocks,
                const Lattice<dim> &lattice,
                const OpenFaces<dim> &open,
                Body<dim> &body);

  /** A particle that left the box. */
  template <int dim>
  struct Departure
  {
    std::uint64_t id;
    int face; ///< number of the face that it passed
    Vector<dim> position;
    Vector<dim> velocity;
  };

  /** Removes the particles that lie outside of the box, beyond walls as far as hold_at_walls() leaves them. */
  template <int dim>
  std::vector<Departure<dim>>
  remove_departed(const Lattice<dim> &lattice, const OpenFaces<dim> &open, Body<dim> &body);
} // namespace magmpm
