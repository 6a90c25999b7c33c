#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/background_mesh.h>

#include <memory>
#include <vector>

namespace dealii::Utilities::MPI
{
  class Partitioner;
}

namespace magmpm
{
  /**
   * The active blocks of all ranks and the exchange of node values between them. Active are the
   * occupied blocks (with particles) and all blocks around them; every rank also holds, as ghosts,
   * the active blocks next to the ones it owns.
   */
  template <int dim>
  class BlockPartition
  {
  public:
    explicit BlockPartition(const BackgroundMesh<dim> &mesh);
    ~BlockPartition();

    /**
     * Finds the active blocks anew. Collective.
     *
     * @param occupied  blocks around which all are to be active, whoever owns them: those with
     *                  particles of this rank, which this rank must own, and others.
     */
    void
    rebuild(const std::vector<Index<dim>> &occupied);

    const BlockSet<dim> &
    blocks() const
    {
      return block_set;
    }

    /** Adds the values on ghost blocks to those of their owners; ghosts are zero afterwards. Collective. */
    void
    add_ghosts_to_owners(NodeField<dim> &field) const;

    /** Copies the owners' values to the ghosts. Collective. */
    void
    update_ghosts(NodeField<dim> &field) const;

  private:
    const BackgroundMesh<dim> &mesh;
    BlockSet<dim> block_set;

    std::unique_ptr<dealii::Utilities::MPI::Partitioner> partitioner;
    mutable std::vector<double> buffer; ///< of the exchange
  };
} // namespace magmpm
