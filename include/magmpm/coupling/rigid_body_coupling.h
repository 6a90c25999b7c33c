#pragma once

#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/boundary/rigid_collision.h>
#include <magmpm/coupling/magnet_forces.h>
#include <magmpm/coupling/rigid_hold.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/box_faces.h>
#include <magmpm/simulation/run_state.h>
#include <magmpm/simulation/time_step_control.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /**
   * The rigid bodies and magnets in the time loop: what moves them and what they do to the material.
   * All ranks hold all of them. A scene without any pays nothing.
   */
  template <int dim>
  class RigidBodyCoupling
  {
  public:
    /** All of these must outlive this object. */
    RigidBodyCoupling(const Parameters<dim> &parameters,
                      ExternalField<dim> &external_field,
                      const MPI_Comm communicator);

    /** Moves sources and bodies to where they are at @p time [s]; free ones stay where they are. */
    void
    set_time(const double time);

    /**
     * Gives free bodies the impulses of gravity and magnetic force, and lets bodies and material collide.
     * Collective if there are free bodies.
     *
     * @param field  {momentum [kg m/s], mass [kg]} on owned nodes, becomes {velocity [m/s], mass [kg]}.
     */
    void
    update_lattice(const BlockSet<dim> &blocks,
                   const double typical_particle_mass,
                   const RunState &state,
                   NodeField<dim> &field);

    /** Moves free bodies by a step with their momenta. */
    void
    advance(RunState &state);

    /**
     * Puts particles back that came through walls or deep into bodies, counts them, and gives free bodies
     * the momentum that they lost. One sum over the ranks.
     *
     * @return the longest way that a particle was put [m], of all ranks, or more; onto a wall: zero.
     */
    double
    hold_particles(const BlockSet<dim> &blocks,
                   const OpenFaces<dim> &open,
                   std::vector<Body<dim>> &bodies,
                   RunState &state);

    /** What of the bodies limits the next step. */
    void
    update_step_conditions(const RunState &state, StepConditions &conditions);

    /** Goes back to where the free bodies of a record are (RigidBodies::record()). */
    void
    restore(const std::vector<double> &record);

    const RigidBodies<dim> &
    bodies() const
    {
      return rigid_bodies;
    }

    /** Force and torque on each source, about its position. */
    std::vector<ForceAndTorque<dim>>
    forces_on_magnets(const RunState &state)
    {
      return magnet_forces.total(state.reactions);
    }

  private:
    /** The impulses of gravity and magnetic force in a step. */
    void
    accelerate(const RunState &state);

    /** Magnetic force on a body and torque about its centre of mass, from those about its source. */
    ForceAndTorque<dim>
    magnetic_force(const std::size_t body, const std::vector<ForceAndTorque<dim>> &forces) const;

    /** Puts particles out that got deep into bodies. @return by body, on this rank. */
    std::vector<RigidHold<dim>>
    push_out(const BlockSet<dim> &blocks, std::vector<Body<dim>> &bodies) const;

    /** Counts what push_out() of all ranks together did, and gives free bodies the momentum. */
    void
    take_pushed(const std::vector<RigidHold<dim>> &pushed, RunState &state);

    const Parameters<dim> &parameters;
    ExternalField<dim> &external_field;
    const MPI_Comm communicator;

    RigidBodies<dim> rigid_bodies;
    const LatticeBoundary<dim> boundary;
    const RigidCollision<dim> collision;
    MagnetForces<dim> magnet_forces;
  };
} // namespace magmpm
