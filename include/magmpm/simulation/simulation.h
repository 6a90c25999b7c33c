#pragma once

#include <magmpm/coupling/rigid_body_coupling.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/box_faces.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_sort.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/results/results.h>
#include <magmpm/simulation/checkpoint.h>
#include <magmpm/simulation/domain_decomposition.h>
#include <magmpm/simulation/rest_check.h>
#include <magmpm/simulation/run_control.h>
#include <magmpm/simulation/run_record.h>
#include <magmpm/simulation/runaway_check.h>
#include <magmpm/simulation/time_step_control.h>

#include <mpi.h>

#include <memory>
#include <optional>
#include <vector>

namespace magmpm
{
  template <int dim>
  class MagneticCoupling;

  /**
   * A scene from its parameters to its results: the time loop of Sun et al. 2021, section 4.3, and
   * what has to happen around it. All the physics is in the rooms.
   */
  template <int dim>
  class Simulation
  {
  public:
    /**
     * @param checkpoint  of an earlier run of this scene, to go on from; otherwise it starts afresh.
     * @throw InputError  if the scene is not that of the checkpoint.
     */
    Simulation(const Parameters<dim> &parameters,
               const MPI_Comm communicator,
               const std::optional<Checkpoint> &checkpoint = {});
    ~Simulation();

    /**
     * Until the end time, or until somebody asks it to stop (see RunControl).
     *
     * @throw RunError if a particle runs away or a solver fails.
     */
    void
    run();

  private:
    /** From no particles to frame 0. */
    void
    begin();

    void
    seed_bodies();

    /** Goes back to where the run was when it wrote a checkpoint. */
    void
    restore(const Checkpoint &checkpoint);

    /** Builds anew, from the particles alone: mesh, blocks, potential problem, order of the particles. */
    void
    set_up_decomposition();

    /** The length of this step, and what limits it. */
    void
    choose_time_step();

    void
    advance_one_step();

    /** Brings particles to the ranks and slots of their blocks; adapts the mesh where they went. */
    void
    regroup_particles();

    /** Gives the artificial attraction, if it is to, the total force of the magnets, and ends theirs. */
    void
    match_attraction();

    /** Adds the impulse of the artificial attraction to the particles. */
    void
    attract_bodies();

    /** Notes whether all material is at rest, if that is to end the run. */
    void
    check_for_rest();

    /** Draws the J of fluids towards that of the lattice, every few steps. */
    void
    relax_fluids();

    /** Solves the potential if the force that particles carry no longer serves, Eqs. (25-33). */
    void
    update_magnetics();

    /** P2G of momentum and mass, summed over the ranks. */
    void
    transfer_to_lattice();

    void
    update_lattice();

    void
    transfer_to_particles();

    void
    update_step_conditions(const std::vector<ParticleExtremes> &extremes);

    double
    time_of_next_frame() const; ///< or of the end [s]

    bool
    is_at_end() const;

    bool
    is_stopped() const;

    bool
    checkpoint_is_due(const bool frame_is_complete) const;

    /**
     * Writes a checkpoint, and brings this run to the very state in which a run resumed from it starts:
     * what is carried along otherwise, such as the mesh, the last potential and its preconditioner, is
     * built anew in both.
     */
    void
    write_checkpoint();

    void
    write_frame();

    void
    write_statistics();

    const Parameters<dim> parameters;
    const MPI_Comm communicator;

    const std::optional<RunRecord> resumed; ///< where an earlier run was
    Results<dim> results;
    parallel::PhaseTimer timer;

    ExternalField<dim> external_field;
    RigidBodyCoupling<dim> rigid_bodies;
    const OpenFaces<dim> open;
    const TimeStepControl time_step_control;
    const RestCheck rest;
    std::unique_ptr<DomainDecomposition<dim>> decomposition;
    std::unique_ptr<MagneticCoupling<dim>> magnetics; ///< null without magnetic material

    std::vector<Body<dim>> bodies;
    NodeField<dim> lattice_field; ///< {momentum or velocity, mass}

    CheckpointFolder checkpoints;
    RunControl control;
    RunControl::Request request = RunControl::Request::none; ///< of all ranks, in the last step

    RunState state;
    StepConditions step_conditions;
    PointAttraction<dim> attraction;
    double typical_particle_mass = 0.; ///< [kg]
    double drift_since_sort      = 0.; ///< the longest way a particle can have gone [m]
  };
} // namespace magmpm
