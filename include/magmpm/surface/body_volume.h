#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace magmpm
{
  /** Numbers on the nodes of a box of the lattice. */
  template <int dim>
  struct NodeBox
  {
    Index<dim> first = {};      ///< node in the lower corner
    Index<dim> count = {};      ///< nodes along each axis
    std::vector<double> values; ///< the first axis running fastest
  };

  /**
   * How full of a body the lattice is: the sum of N J V_0 over dx^dim [-] at its nodes, with the
   * quadratic B-splines N of P2G and the volumes J V_0 of the particles of all ranks. A rank holds the
   * blocks around its own particles, and no rank holds all.
   */
  template <int dim>
  class BodyVolume
  {
  public:
    /** Scatters the volumes of the particles. Collective. */
    BodyVolume(const Body<dim> &body, const Lattice<dim> &lattice, const MPI_Comm communicator);

    /** The nodes of all particles and an empty layer around them; without particles no nodes. No values. */
    const NodeBox<dim> &
    box() const
    {
      return all_nodes;
    }

    /**
     * Calls @p use on rank 0 with slab after slab of box(), from below along the last axis. A slab
     * begins with the last layer of nodes of the one before. Collective; if @p use throws, all ranks do.
     *
     * @param n_nodes  of a slab, about.
     */
    void
    for_each_slab(const std::function<void(const NodeBox<dim> &)> &use,
                  const std::size_t n_nodes) const;

  private:
    using BlockValues = std::array<double, nodes_per_block<dim>>;

    const MPI_Comm communicator;
    NodeBox<dim> all_nodes;
    std::vector<Index<dim>> blocks; ///< around this rank's particles
    std::vector<BlockValues> values;
    std::unordered_map<std::uint64_t, std::size_t> slots; ///< by block_key()

    BlockValues &
    values_of(const Index<dim> &block);

    /** The blocks of some layers as numbers: coordinates and values. */
    std::vector<double>
    packed_blocks(const int first_layer, const int end_layer) const;

    /** Adds packed blocks to the nodes of a slab. */
    static void
    add(const std::vector<double> &packed, NodeBox<dim> &slab);
  };
} // namespace magmpm
