#pragma once

#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/wall_images.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/smoothed_volume.h>

#include <vector>

namespace magmpm
{
  /**
   * Momentum and velocity on the lattice in a step, from the particles and back to them, with images behind
   * walls, see WallImages.
   */
  template <int dim>
  class LatticeMotion
  {
  public:
    explicit LatticeMotion(const Parameters<dim> &parameters);

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
     * Eqs. (33), (34): velocities, as gravity, damping, walls and scripted bodies leave them, on owned nodes.
     * Collective.
     */
    void
    update_velocity(const Clock &clock,
                    const BlockPartition<dim> &partition,
                    const LatticeBoundary<dim> &boundary,
                    SolidContact<dim> &contact);

    /** {velocity [m/s], mass [kg]}. */
    NodeField<dim> &
    field()
    {
      return motion;
    }

    /** See update_lattice_momentum(); without blocks if nobody wants it. */
    NodeField<dim> &
    unconstrained_field()
    {
      return unconstrained;
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
    /** Adds ghosts to their owners, with the images behind walls once these are chosen. */
    void
    sum(const BlockPartition<dim> &partition, NodeField<dim> &momentum) const;

    /** The other way. */
    void
    copy(const BlockPartition<dim> &partition, NodeField<dim> &velocity) const;

    const Lattice<dim> lattice;
    const TimeFunction<Vector<dim>> gravity;
    const double damping_rate;
    const double particle_mass;
    const bool is_filtered; ///< whether any body wants P v
    const bool has_smoothed_bodies;

    WallImages<dim> images;

    NodeField<dim> motion;
    NodeField<dim> unconstrained; ///< velocities without walls and bodies; used if is_filtered
    NodeField<dim> filtered;      ///< P v, likewise
    NodeField<dim> taken;         ///< v and what FMPM gives back, likewise

    NodeField<dim, NodeStrain> strain; ///< used if has_smoothed_bodies
  };
} // namespace magmpm
