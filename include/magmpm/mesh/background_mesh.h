#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/mesh/mesh_parameters.h>

#include <mpi.h>

#include <memory>
#include <vector>

namespace dealii::parallel::distributed
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace magmpm
{
  /** What BackgroundMesh::adapt() found and did. */
  struct MeshAdaptation
  {
    bool is_refined         = false; ///< the cells are others now; so may be their owners
    bool is_rebalanced      = false; ///< only the owners of cells are others
    double imbalance_before = 1.;    ///< load of the most loaded rank over the mean
    double imbalance        = 1.;    ///< the same now

    bool
    is_change() const
    {
      return is_refined || is_rebalanced;
    }
  };

  /**
   * The p4est mesh of the potential box, aligned with the lattice. Where material is, cells have an
   * edge of 2 dx, so that the support points of FE_Q(2) are the lattice nodes, or of dx; they coarsen
   * 2:1 away from it. The 2^dim cells of edge 2 dx of one parent are a block (edge 4 dx), which p4est
   * keeps on one rank, as the weights of the cells do with the 4^dim of edge dx: the mesh is the one
   * partition of blocks, nodes and particles.
   *
   * A cell's place on the lattice is integer arithmetic: lattice.nearest_node(vertex 0) is its
   * lower node, its edge a power of two times dx.
   */
  template <int dim>
  class BackgroundMesh
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<dim, dim>;

    BackgroundMesh(const MPI_Comm communicator,
                   const Lattice<dim> &lattice,
                   const MeshParameters<dim> &parameters);
    ~BackgroundMesh();

    /**
     * Makes all blocks around those that the ranks give fine, and spreads the cells over the ranks by
     * weight. A mesh that serves already is left alone unless the load is too uneven; if it does not
     * serve, it is also refined where material will soon be, and coarsened everywhere else. Collective.
     *
     * @param blocks      blocks with material, of this rank's particles (any owner).
     * @param weights     particles in each of them.
     * @param approached  blocks that will have material before the mesh should have to change again.
     */
    MeshAdaptation
    adapt(const std::vector<Index<dim>> &blocks,
          const std::vector<unsigned int> &weights,
          const std::vector<Index<dim>> &approached = {});

    /**
     * Owner rank of each block. Blocks outside the box belong to the owner of the nearest inside.
     * Collective (deal.II compares the manifolds of all ranks in each search).
     */
    std::vector<unsigned int>
    owners(const std::vector<Index<dim>> &blocks) const;

    const Triangulation &
    triangulation() const;

    const Lattice<dim> &
    lattice() const
    {
      return the_lattice;
    }

    const MeshParameters<dim> &
    parameters() const
    {
      return the_parameters;
    }

    MPI_Comm
    communicator() const
    {
      return the_communicator;
    }

    /** Counts the changes of the mesh: what is built on the mesh is valid for one revision. */
    unsigned int
    revision() const
    {
      return the_revision;
    }

  private:
    const MPI_Comm the_communicator;
    const Lattice<dim> the_lattice;
    const MeshParameters<dim> the_parameters;
    unsigned int the_revision = 0;

    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace magmpm
