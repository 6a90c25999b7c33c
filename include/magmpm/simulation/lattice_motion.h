#pragma once

#include <magmpm/boundary/group_motion.h>
#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/group_contact.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/smoothed_volume.h>
#include <magmpm/simulation/weld_check.h>

#include <vector>

namespace magmpm
{
  /**
   * Momentum and velocity on the lattice in a step, from the particles and back to them, with images behind
   * walls, see WallImages. Bodies of each contact group have a lattice of their own.
   */
  template <int dim>
  class LatticeMotion
  {
  public:
    LatticeMotion(const Parameters<dim> &parameters, const MPI_Comm communicator);

    /** Makes room for new blocks. */
    void
    reinit(const int n_blocks);

    /** Whether any body is nearly incompressible. */
    bool
    smooths_volume() const
    {
      return has_smoothed_bodies;
    }

    /**
     * Smooths the volume ratios of nearly incompressible solids where they are now; P2G does so itself, and
     * their elastic energy counts on it. Collective.
     */
    void
    smooth_volume(const BlockPartition<dim> &partition, std::vector<Body<dim>> &bodies);

    /** P2G, Eq. (28), summed over the ranks. */
    void
    sum_momentum(const BlockPartition<dim> &partition,
                 const double time_step,
                 std::vector<Body<dim>> &bodies);

    /**
     * Eqs. (33), (34): velocities, as contact between groups, gravity, damping, walls and scripted bodies leave
     * them, on owned nodes. Collective.
     */
    void
    update_velocity(const Clock &clock,
                    const BlockPartition<dim> &partition,
                    const LatticeBoundary<dim> &boundary,
                    const std::vector<Body<dim>> &bodies,
                    std::vector<SolidContact<dim>> &contacts);

    /** Between groups, in the last step. */
    const GroupContact<dim> &
    contact() const
    {
      return group_contact;
    }

    /** Within groups. */
    WeldCheck<dim> &
    weld_check()
    {
      return welds;
    }

    /** What is on the lattice, by contact group from the lowest on. */
    std::vector<GroupMotion<dim>> &
    by_group()
    {
      return groups;
    }

    /** A node whose mass is next to nothing beside this one is left alone [kg]. */
    double
    typical_mass() const
    {
      return particle_mass;
    }

    /** To be called once velocities are what they will be in this step: gives all ranks what G2P needs. */
    void
    finish(const BlockPartition<dim> &partition,
           const double time_step,
           std::vector<Body<dim>> &bodies);

    /** G2P, Eqs. (35)-(37); see lattice_to_particles(). */
    std::vector<ParticleExtremes>
    move_particles(const BlockPartition<dim> &partition,
                   const double time_step,
                   std::vector<Body<dim>> &bodies) const;

  private:
    /** Filters the velocity of a group, if any body wants that. */
    void
    filter(const BlockPartition<dim> &partition,
           const double time_step,
           std::vector<Body<dim>> &bodies,
           GroupMotion<dim> &group) const;

    /** Adds ghosts to their owners, with the images behind walls once these are chosen. */
    void
    sum(const BlockPartition<dim> &partition,
        const WallImages<dim> &images,
        NodeField<dim> &momentum) const;

    /** The other way. */
    void
    copy(const BlockPartition<dim> &partition,
         const WallImages<dim> &images,
         NodeField<dim> &velocity) const;

    const Lattice<dim> lattice;
    const TimeFunction<Vector<dim>> gravity;
    const double damping_rate;
    const double particle_mass;
    const bool is_filtered; ///< whether any body wants P v
    const bool has_smoothed_bodies;

    std::vector<GroupMotion<dim>> groups;
    GroupContact<dim> group_contact;
    WeldCheck<dim> welds;

    NodeField<dim, NodeStrain> strain; ///< used if has_smoothed_bodies
  };
} // namespace magmpm
