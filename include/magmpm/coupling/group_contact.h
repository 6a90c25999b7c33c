#pragma once

#include <magmpm/boundary/group_contact_law.h>
#include <magmpm/boundary/group_contact_parameters.h>
#include <magmpm/boundary/group_motion.h>
#include <magmpm/coupling/shared_node_sums.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * Contact between bodies of different contact groups, where they touch: at nodes that both reach the law of
   * group_contact_law.h, by the gap between their particles. It is an impulse of the step like that of stress: the
   * momenta of both change by the opposite, and walls and rigid bodies have their say afterwards. If more than
   * two groups share a node each pair of them touches, one after the other.
   */
  template <int dim>
  class GroupContact
  {
  public:
    /** @param groups  of the bodies, in order. @param listed  what the user says of pairs of them. */
    GroupContact(const Lattice<dim> &lattice,
                 const std::vector<int> &groups,
                 const std::vector<GroupContactParameters> &listed,
                 const MPI_Comm communicator);

    /**
     * Adds the impulses of a step. Nothing happens with one group. Collective.
     *
     * @param least_mass  of a node that counts [kg].
     * @param motions     momenta of this step on owned nodes, by group.
     */
    void
    act(const BlockPartition<dim> &partition,
        const std::vector<Body<dim>> &bodies,
        const double time_step,
        const double least_mass,
        std::vector<GroupMotion<dim>> &motions);

    /** Of contact on this rank at the end of the step [J], and the depth of the deepest at its start [m]. */
    double
    energy() const
    {
      return the_energy;
    }

    double
    depth() const;

    /**
     * A line for each pair of groups that overlaps by more than 0.02 dx now, after act(): bodies that start so are
     * thrown apart. Collective.
     */
    std::vector<std::string>
    find_overlaps(const std::vector<Body<dim>> &bodies) const;

  private:
    /** Two groups, by their places in the list of groups. */
    struct Pair
    {
      std::size_t a, b;
      GroupContactParameters contact;
      double depth; ///< of the deepest contact on this rank [m]
    };

    /** Marks the nodes that both reach, ghosts too. @return whether there are any, on any rank. */
    bool
    find_shared_nodes(const BlockPartition<dim> &partition,
                      const double least_mass,
                      const NodeField<dim> &a,
                      const NodeField<dim> &b);

    /** Material and gaps of both on the shared nodes. */
    void
    find_sums(const BlockPartition<dim> &partition,
              const std::vector<Body<dim>> &bodies,
              const Pair &pair);

    /** Adds the impulses on the shared nodes that this rank owns. */
    void
    press(const BlockSet<dim> &blocks,
          const double time_step,
          Pair &pair,
          NodeField<dim> &a,
          NodeField<dim> &b);

    /** The direction with the largest gap, and what is known of the contact along it but its mass; false if none is. */
    bool
    find_surface(const int slot, const int n, SharedSurface<dim> &surface) const;

    const Lattice<dim> lattice;
    const MPI_Comm communicator;
    std::vector<Pair> pairs;
    double the_energy = 0.;
    NodeField<dim, SingleScalar> shared;
    NodeField<dim, SharedNodeMaterial> material;
    NodeField<dim, SharedNodeGaps> gaps;
  };
} // namespace magmpm
