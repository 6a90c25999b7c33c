#pragma once

#include <magmpm/boundary/group_motion.h>
#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/boundary/rigid_collision.h>
#include <magmpm/boundary/solid_contact.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/coupling.h>
#include <magmpm/coupling/magnet_forces.h>
#include <magmpm/coupling/rigid_hold.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/motion/time_function.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/box_faces.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /** What the coupling of rigid bodies takes from the parameters of a scene. */
  template <int dim>
  struct RigidBodyCouplingParameters
  {
    Lattice<dim> lattice;
    WallParameters<dim> walls;
    TimeFunction<Vector<dim>> gravity; ///< [m/s^2]
    std::vector<SourceParameters<dim>> sources;
    std::vector<RigidBodyProperties<dim>> magnet_bodies; ///< of each source, if it is a rigid body
    std::vector<RigidBodyParameters<dim>> rigid_bodies;
    std::vector<int> contact_groups; ///< of the bodies, in order
  };

  /** What rigid bodies and walls must remember of the particles that they hold. */
  struct HoldCounts
  {
    std::size_t held   = 0;  ///< particles put back onto walls so far, all ranks
    std::size_t inside = 0;  ///< in rigid bodies in the last step, all ranks
    std::size_t pushed = 0;  ///< out of rigid bodies so far, all ranks
    double deepest     = 0.; ///< of a particle in a rigid body since the last row, all ranks [m]
    double energy      = 0.; ///< of contact of solids in the last step, all ranks [J]
    double depth       = 0.; ///< of the deepest contact since the last row, all ranks [m]

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &held;
      archive &inside;
      archive &pushed;
      archive &deepest;
      archive &energy;
      archive &depth;
    }
  };

  /** What rigid bodies and walls did in a step: on this rank, and after the sums over ranks on all. */
  template <int dim>
  struct HoldStep
  {
    int contact_is_near   = 1;         ///< a solid may touch a surface in the next step
    double contact_energy = 0.;        ///< [J]
    double contact_depth  = 0.;        ///< of the deepest contact [m]
    std::size_t held      = 0;         ///< particles put back onto walls
    std::vector<RigidHold<dim>> holds; ///< by body with a surface

    void
    reduce(parallel::Reduction &reduction)
    {
      reduction.max(contact_is_near);
      reduction.sum(contact_energy);
      reduction.max(contact_depth);
      reduction.sum(held);
      for (RigidHold<dim> &hold : holds)
        {
          reduction.sum(hold.n_inside);
          reduction.sum(hold.n_held);
          reduction.max(hold.deepest);
          reduction.sum(hold.impulse);
          reduction.sum(hold.angular_impulse);
        }
    }
  };

  /**
   * Walls, rigid bodies and magnets in the time loop: what moves them and what they do to the material.
   * All ranks hold all of them. A scene without rigid bodies and magnets pays for walls only.
   */
  template <int dim>
  class RigidBodyCoupling : public Coupling
  {
  public:
    /**
     * @param external_field  must outlive this object.
     * @param reactions       of the material on the sources, in the present step; must outlive this object.
     */
    RigidBodyCoupling(const RigidBodyCouplingParameters<dim> &parameters,
                      ExternalField<dim> &external_field,
                      const CarriedReactions<dim> &reactions,
                      const MPI_Comm communicator);

    /** Moves sources and bodies to where they are at @p time [s]; free ones stay where they are. */
    void
    set_time(const double time);

    /** What walls and scripted bodies do to the velocity of a node. */
    const LatticeBoundary<dim> &
    lattice_boundary() const
    {
      return boundary;
    }

    /** Finds where solids touch surfaces, for contacts(). Collective if they may do so on any rank. */
    void
    find_contact(const BlockPartition<dim> &partition, const std::vector<Body<dim>> &bodies);

    /** What walls that slip or separate and rigid bodies do to solids, by contact group. */
    std::vector<SolidContact<dim>> &
    contacts()
    {
      return solid_contacts;
    }

    /**
     * Gives free bodies the impulses of gravity and magnetic force, and lets bodies and material collide.
     * Collective if there are free bodies, or fluids and bodies that these touch.
     *
     * @param typical_particle_mass  [kg]
     * @param groups                 velocities on owned nodes, by contact group.
     */
    void
    collide(const Clock &clock,
            const BlockPartition<dim> &partition,
            const bool has_fluids,
            const double typical_particle_mass,
            std::vector<GroupMotion<dim>> &groups);

    /** Moves free bodies by a step with their momenta. */
    void
    advance(const Clock &clock);

    /**
     * Puts particles back that came through walls or deep into bodies, on this rank. take_reduced() gives
     * free bodies the momentum that these lost.
     */
    void
    hold_particles(const BlockSet<dim> &blocks,
                   const OpenFaces<dim> &open,
                   std::vector<Body<dim>> &bodies);

    /** Adds contact between bodies, on this rank, to that with walls. @param energy, depth  [J], [m] */
    void
    note_contact(const double energy, const double depth);

    /** The longest way that hold_particles() put a particle of any rank, or more [m]; known after take_reduced(). */
    double
    longest_push() const;

    const RigidBodies<dim> &
    bodies() const
    {
      return rigid_bodies;
    }

    /** Force and torque on each source, about its position, by the material and by other sources. */
    std::vector<ForceAndTorque<dim>>
    forces_on_magnets()
    {
      return magnet_forces.total(reactions);
    }

    void
    limit_step(StepConditions &conditions) const override;

    void
    reduce(parallel::Reduction &reduction) override;

    void
    take_reduced() override;

    void
    prepare_row() override;

    void
    end_row() override;

    /**
     * Force and torque of each magnet that has a place, pose and motion of each rigid body that is not a
     * scripted magnet, and, if there is any rigid body with a surface, how deep particles are in these.
     */
    void
    add_columns(ColumnTable &table) const override;

    SectionTitle
    title() const override;

    std::string
    save() const override;

    void
    load(const std::string &bytes) override;

  private:
    /** The impulses of gravity and magnetic force in a step. */
    void
    accelerate(const Clock &clock);

    /** Forces on the sources, if a magnet is free; otherwise nobody needs them, and there are none. */
    std::vector<ForceAndTorque<dim>>
    forces_on_free_magnets() const;

    /** Magnetic force on a body and torque about its centre of mass, from those about its source. */
    ForceAndTorque<dim>
    magnetic_force(const std::size_t body, const std::vector<ForceAndTorque<dim>> &forces) const;

    /** Columns of the pose and motion of a rigid body. */
    void
    add_pose(const RigidBody<dim> &body, ColumnTable &table) const;

    const RigidBodyCouplingParameters<dim> parameters;
    ExternalField<dim> &external_field;
    const CarriedReactions<dim> &reactions;
    const MPI_Comm communicator;

    RigidBodies<dim> rigid_bodies;
    const LatticeBoundary<dim> boundary;
    std::vector<SolidContact<dim>> solid_contacts; ///< by contact group
    const RigidCollision<dim> collision;
    mutable MagnetForces<dim> magnet_forces; ///< remembers what sources do to each other
    std::vector<ForceAndTorque<dim>> forces_of_row;

    HoldCounts counts;
    HoldStep<dim> now; ///< in this step
  };
} // namespace magmpm
