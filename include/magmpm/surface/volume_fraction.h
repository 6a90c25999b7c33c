#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /** Whose volume is asked for: of particles of these bodies, all together. */
  struct MaterialSelection
  {
    std::vector<bool> bodies; ///< whether a body counts, by its number

    bool
    operator==(const MaterialSelection &other) const
    {
      return bodies == other.bodies;
    }
  };

  /** One body alone. */
  template <int dim>
  MaterialSelection
  select_body(const std::vector<Body<dim>> &bodies, const std::size_t body)
  {
    MaterialSelection selection{std::vector<bool>(bodies.size(), false)};
    selection.bodies[body] = true;
    return selection;
  }

  /** All bodies for which @p counts(body). */
  template <int dim, typename Predicate>
  MaterialSelection
  select_bodies(const std::vector<Body<dim>> &bodies, const Predicate &counts)
  {
    MaterialSelection selection;
    for (const Body<dim> &body : bodies)
      selection.bodies.push_back(counts(body));
    return selection;
  }

  /**
   * How full of some material the lattice is: sum over particles of N_i J V_0/dx^dim [-], with the quadratic
   * B-splines of P2G. This is where every question for the place of material begins: the magnetic
   * medium's (with its content, magnetic_content_to_lattice()), surfaces.
   *
   * @param bodies  sorted into the blocks.
   * @param field   on the active blocks; it becomes this rank's part of the fraction, ghosts too.
   */
  template <int dim>
  void
  scatter_volume(const std::vector<Body<dim>> &bodies,
                 const MaterialSelection &selection,
                 const BlockSet<dim> &blocks,
                 const Lattice<dim> &lattice,
                 NodeField<dim, SingleScalar> &field);

  /** The same of all ranks, ghosts up to date. Collective. */
  template <int dim>
  NodeField<dim, SingleScalar>
  volume_fraction(const std::vector<Body<dim>> &bodies,
                  const MaterialSelection &selection,
                  const BlockPartition<dim> &partition,
                  const Lattice<dim> &lattice);
} // namespace magmpm
