#pragma once

#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/io/parameters.h>
#include <magmpm/io/results.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/mesh/background_mesh.h>
#include <magmpm/mesh/block_partition.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_sort.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/runaway_check.h>
#include <magmpm/time_step_control.h>

#include <mpi.h>

#include <memory>
#include <vector>

namespace dealii
{
  class TimerOutput;
}

namespace magmpm
{
  template <int dim>
  class PotentialProblem;

  /**
   * A scene from its parameters to its results: the time loop of Sun et al. 2021, section 4.3, and
   * what has to happen around it. All the physics is in the rooms.
   */
  template <int dim>
  class Simulation
  {
  public:
    Simulation(const Parameters<dim> &parameters, const MPI_Comm communicator);
    ~Simulation();

    /** @throw RunError if a particle runs away or a solver fails. */
    void
    run();

  private:
    void
    seed_bodies();

    void
    advance_one_step();

    /** Brings particles to the ranks and slots of their blocks; adapts the mesh where they went. */
    void
    regroup_particles();

    void
    migrate_to_owners(const OccupiedBlocks<dim> &occupied);

    bool
    solve_is_due();

    /** Solves the potential and lets the particles carry the force, Eqs. (25-33). */
    void
    solve_magnetics();

    /** The densities of grains on the nodes, summed over the ranks, ghosts up to date. */
    NodeField<dim>
    magnetic_content();

    /** Finds the potential of @p content, Eqs. (25)-(30). */
    void
    solve_potential(const NodeField<dim> &content);

    /** Accelerations of the nodes [m/s^2] from forces [N] and masses, in place. */
    void
    forces_to_accelerations(const NodeField<dim> &masses, NodeField<dim> &force) const;

    /** Lets the force that particles carry follow the motion since the last solve. */
    void
    advance_force();

    /** Gives particles the accelerations of the nodes [m/s^2], and their rate of change. */
    void
    carry_force(const NodeField<dim> &accelerations);

    /** P2G of momentum and mass, summed over the ranks. */
    void
    transfer_to_lattice(const double time_step);

    void
    update_lattice();

    void
    transfer_to_particles();

    void
    update_step_conditions(const std::vector<ParticleExtremes> &extremes);

    /** Sums of each body over all ranks. */
    std::vector<ParticleSums<dim>>
    sums_of_bodies() const;

    void
    write_frame();

    void
    write_statistics();

    const Parameters<dim> parameters;
    const MPI_Comm communicator;

    Results<dim> results;
    std::unique_ptr<dealii::TimerOutput> timer;

    ExternalField<dim> external_field;
    LatticeBoundary<dim> boundary;
    BackgroundMesh<dim> mesh;
    BlockPartition<dim> partition;
    const TimeStepControl time_step_control;

    std::vector<Body<dim>> bodies;
    NodeField<dim> lattice_field; ///< {momentum or velocity, mass}

    std::unique_ptr<PotentialProblem<dim>> magnetics; ///< null without magnetic material

    RunState state;
    StepConditions step_conditions;
    double typical_particle_mass    = 0.; ///< [kg]
    unsigned int mesh_of_last_solve = 0;  ///< its revision
    double drift_since_sort         = 0.; ///< the longest way a particle can have gone [m]
    double drift_since_solve        = 0.; ///< the same of magnetic particles, or more [m]
    double path_since_solve         = 0.; ///< the sum of the steps of the fastest particles [m]
    double carried_way              = 0.; ///< for which the carried force was advanced [m]
  };
} // namespace magmpm
