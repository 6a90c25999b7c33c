#pragma once

#include <magmpm/mesh/background_mesh.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/box_faces.h>
#include <magmpm/particles/particle_sort.h>

#include <mpi.h>

#include <cstddef>
#include <string>
#include <vector>

namespace magmpm
{
  /** What a regrouping of particles did, counted over all ranks. */
  struct Regrouping
  {
    std::size_t n_lost = 0;     ///< particles that had left the box and were removed
    std::string first_lost;     ///< one of them in words
    std::size_t n_migrated = 0; ///< particles that changed their rank
    MeshAdaptation mesh;
  };

  /** A sentence about the particles that were lost. @param time  of now [s]. */
  std::string
  report(const Regrouping &regrouping, const double time);

  /** A sentence about the work of the ranks, dealt out anew. */
  std::string
  report(const MeshAdaptation &mesh, const int n_ranks);

  /**
   * Which rank holds which part of the box: the mesh, the blocks around the particles, and the
   * particles, each on the rank and in the slot of its block.
   */
  template <int dim>
  class DomainDecomposition
  {
  public:
    DomainDecomposition(const Parameters<dim> &parameters, const MPI_Comm communicator);

    /**
     * Brings all particles to the ranks and slots of their blocks; adapts the mesh to where they
     * went. Collective.
     */
    Regrouping
    regroup(std::vector<Body<dim>> &bodies);

    /** In a step no particle of any rank went further than this [m]. */
    void
    note_motion(const double way)
    {
      drift += way;
    }

    /** Whether a particle could leave the arena of its block in the next step. */
    bool
    regrouping_is_due() const;

    const BackgroundMesh<dim> &
    mesh() const
    {
      return background_mesh;
    }

    const BlockPartition<dim> &
    partition() const
    {
      return block_partition;
    }

    const BlockSet<dim> &
    blocks() const
    {
      return block_partition.blocks();
    }

  private:
    /** Where the particles will be before the mesh should have to change again. */
    std::vector<Index<dim>>
    blocks_ahead(const std::vector<Body<dim>> &bodies) const;

    std::size_t
    migrate_to_owners(const OccupiedBlocks<dim> &occupied, std::vector<Body<dim>> &bodies) const;

    const Lattice<dim> lattice;
    const OpenFaces<dim> open_faces;
    const MPI_Comm communicator;
    const bool has_force; ///< of magnets
    BackgroundMesh<dim> background_mesh;
    BlockPartition<dim> block_partition;
    double drift =
      0.; ///< the longest way that a particle can have gone since they were grouped [m]
  };
} // namespace magmpm
