#pragma once

#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/domain_decomposition.h>
#include <magmpm/io/parameters.h>
#include <magmpm/io/results.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/box_faces.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_sort.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/runaway_check.h>
#include <magmpm/time_step_control.h>

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class TimerOutput;
}

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
    Simulation(const Parameters<dim> &parameters, const MPI_Comm communicator);
    ~Simulation();

    /** @throw RunError if a particle runs away or a solver fails. */
    void
    run();

  private:
    /** Empty ones, as at the start: the mesh, its blocks, and the potential problem on them. */
    void
    set_up_decomposition();

    void
    seed_bodies();

    void
    advance_one_step();

    /** Brings particles to the ranks and slots of their blocks; adapts the mesh where they went. */
    void
    regroup_particles();

    /** @throw RunError unless such particles are to be removed. @param first  one of them in words. */
    void
    report_lost_particles(const std::size_t n_lost, const std::string &first);

    /** Draws J of fluids towards that of the lattice. */
    void
    relax_density();

    /** Solves the potential if the force that particles carry no longer serves, Eqs. (25-33). */
    void
    update_magnetics();

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
    const OpenFaces<dim> open;
    const TimeStepControl time_step_control;
    std::unique_ptr<DomainDecomposition<dim>> decomposition;
    std::unique_ptr<MagneticCoupling<dim>> magnetics; ///< null without magnetic material

    std::vector<Body<dim>> bodies;
    NodeField<dim> lattice_field; ///< {momentum or velocity, mass}

    RunState state;
    StepConditions step_conditions;
    double typical_particle_mass = 0.; ///< [kg]
    double drift_since_sort      = 0.; ///< the longest way a particle can have gone [m]
  };
} // namespace magmpm
