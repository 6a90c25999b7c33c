#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /** By which volume a particle counts. */
  enum class ParticleVolume
  {
    undeformed, ///< V_0
    deformed    ///< J V_0
  };

  /** Whose volume is asked for: of particles of these bodies, all together. */
  struct MaterialSelection
  {
    std::vector<bool> bodies; ///< whether a body counts, by its number
    ParticleVolume volume = ParticleVolume::deformed;

    bool
    operator==(const MaterialSelection &other) const
    {
      return bodies == other.bodies && volume == other.volume;
    }
  };

  /** One body alone. */
  template <int dim>
  MaterialSelection
  select_body(const std::vector<Body<dim>> &bodies,
              const std::size_t body,
              const ParticleVolume volume = ParticleVolume::deformed)
  {
    MaterialSelection selection{std::vector<bool>(bodies.size(), false), volume};
    selection.bodies[body] = true;
    return selection;
  }

  /** All bodies for which @p counts(body). */
  template <int dim, typename Predicate>
  MaterialSelection
  select_bodies(const std::vector<Body<dim>> &bodies,
                const Predicate &counts,
                const ParticleVolume volume = ParticleVolume::deformed)
  {
    MaterialSelection selection{{}, volume};
    for (const Body<dim> &body : bodies)
      selection.bodies.push_back(counts(body));
    return selection;
  }

  /**
   * How full of some material the lattice is: sum over particles of N_i V/dx^dim [-], with the quadratic
   * B-splines of P2G. This is where every question for the place of material begins: the magnetic
   * medium's (with its content, magnetic_content_to_lattice()), the density of fluids, surfaces.
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

  /** How full of a body the lattice is, on the nodes of a box around it. */
  template <int dim>
  struct VolumeFraction
  {
    Index<dim> first = {};      ///< node in the lower corner of the box
    Index<dim> count = {};      ///< nodes along each axis; all 0 without particles
    std::vector<double> values; ///< sum of N J V_0 over dx^dim [-], the first axis running fastest
  };

  /**
   * Scatters the volumes J V_0 of the particles of all ranks with the quadratic B-splines of P2G. The
   * outermost nodes of the box are empty. Collective; the values arrive on rank 0 alone. Holds the box on
   * every rank: to be replaced by the field above.
   */
  template <int dim>
  VolumeFraction<dim>
  volume_fraction(const Body<dim> &body, const Lattice<dim> &lattice, const MPI_Comm communicator);
} // namespace magmpm
