#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/background_mesh.h>
#include <magmpm/mesh/mirror_images.h>

#include <vector>

namespace magmpm
{
  /** How often ranks exchanged the values of fields, and the lanes that these had, summed up. */
  struct ExchangeCount
  {
    unsigned long n_exchanges = 0;
    unsigned long n_lanes     = 0;
  };

  /**
   * The active blocks of all ranks and the exchange of node values between them. Active are the
   * occupied blocks (with particles) and all blocks around them; every rank also holds, as ghosts,
   * the active blocks next to the ones it owns. Only lanes that hold a quantity travel.
   *
   * With a Parity the exchange takes care of the images of what stands in front of shielded walls too,
   * which are the mirrors of this partition.
   */
  template <int dim>
  class BlockPartition
  {
  public:
    explicit BlockPartition(const BackgroundMesh<dim> &mesh);

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
    add_ghosts_to_owners(NodeNumbers<dim> &field) const;

    /** The same, and adds the images of material behind shielded walls. */
    void
    add_ghosts_to_owners(NodeNumbers<dim> &field, const Parity &parity) const;

    /** Copies the owners' values to the ghosts. Collective. */
    void
    update_ghosts(NodeNumbers<dim> &field) const;

    /** The same, after nodes behind shielded walls became images of those in front. */
    void
    update_ghosts(NodeNumbers<dim> &field, const Parity &parity) const;

    /** Shielded walls: there the potential's box ends, and material goes on as in a mirror. */
    const MirrorWalls<dim> &
    walls() const
    {
      return mirrors;
    }

    /** All exchanges of this object, for tests and for those who wonder where time goes. */
    const ExchangeCount &
    exchanges() const
    {
      return count;
    }

  private:
    /** Blocks whose values go to another rank, or come from there. */
    struct Message
    {
      int rank;
      std::vector<int> slots;
    };

    /** Finds the ghosts and who has blocks of this rank as ghosts. @return the ghost blocks. */
    std::vector<Index<dim>>
    find_ghosts(const std::vector<Index<dim>> &owned);

    /** Sends the values of some blocks; take(number of the field, number that arrived) for others. */
    template <typename Take>
    void
    exchange(const std::vector<Message> &outgoing,
             const std::vector<Message> &incoming,
             NodeNumbers<dim> &field,
             const Take &take) const;

    const BackgroundMesh<dim> &mesh;
    const MirrorWalls<dim> mirrors;
    BlockSet<dim> block_set;

    std::vector<Message> ghosts;       ///< by owner
    std::vector<Message> ghosts_there; ///< owned blocks, by the rank that has them as ghosts

    mutable std::vector<double> buffer; ///< of the exchange
    mutable ExchangeCount count;
  };
} // namespace magmpm
