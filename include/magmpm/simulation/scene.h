#pragma once

#include <magmpm/coupling/body_forces.h>
#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/fluid_density.h>
#include <magmpm/coupling/magnetic_coupling.h>
#include <magmpm/coupling/rigid_body_coupling.h>
#include <magmpm/coupling/surface_tension.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/simulation/domain_decomposition.h>
#include <magmpm/simulation/lattice_motion.h>
#include <magmpm/simulation/scene_state.h>

#include <mpi.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace magmpm
{
  /** What a caller wants of a step. */
  struct StepRequest
  {
    /** The step ends at this time at the latest [s], later than now. */
    double until = std::numeric_limits<double>::infinity();

    /** Whether SceneState::sums are to be those after the step. */
    bool wants_sums = false;

    /** Numbers of the caller's that go with those of the step in its one exchange between the ranks. */
    std::function<void(parallel::Reduction &)> reduce_along;
  };

  /**
   * A scene: its particles, magnets and rigid bodies, and a step in time, section 4.3 of Sun et al. 2021.
   * All the physics is in the rooms and in the couplings between them. A scene reads and writes no file,
   * takes no signal and prints nothing: that is the business of Run, or of whoever uses it as a library:
   *
   *   Scene<3> scene(read_parameters<3>(read_parameter_file("scene.prm")), MPI_COMM_WORLD);
   *   scene.begin();
   *   while (scene.time() < 0.1)
   *     scene.step();
   *   scene.force_on_magnet("ball").force;
   *
   * All functions that change it are collective.
   */
  template <int dim>
  class Scene
  {
  public:
    /** The names of the phases of timer(), the verbs of the algorithm. */
    static const std::vector<std::string> phases;

    /** @throw InputError  if a magnet or rigid body cannot be made. */
    Scene(const Parameters<dim> &parameters, const MPI_Comm communicator);
    ~Scene();

    /**
     * From no particles to the start of the first step, the first solve of the potential included.
     *
     * @throw InputError  if a body holds no particle.
     */
    void
    begin();

    /**
     * One step, as long as is stable.
     *
     * @throw RunError  if a particle runs away or a solver fails.
     */
    void
    step(const StepRequest &request = {});

    double
    time() const
    {
      return state.clock.time;
    }

    /** Steps and what they did so far. */
    const SceneState<dim> &
    progress() const
    {
      return state;
    }

    /** SceneState::sums of all bodies together. */
    ParticleSums<dim>
    total() const;

    /** With this rank's particles. */
    const std::vector<Body<dim>> &
    bodies() const
    {
      return all_bodies;
    }

    const RigidBodies<dim> &
    rigid_bodies() const
    {
      return holder.bodies();
    }

    const ExternalField<dim> &
    magnets() const
    {
      return external_field;
    }

    const MagneticCoupling<dim> &
    magnetics() const
    {
      return magnetic;
    }

    /** Force and torque on a magnet. @throw InputError  if there is none of that name. */
    ForceAndTorque<dim>
    force_on_magnet(const std::string &name);

    /** Finds the potential on the present mesh, if that changed since the last solve. */
    void
    update_potential();

    /** Moves magnets and rigid bodies to the present time, where the next step finds them. */
    void
    move_bodies_to_now();

    /** The columns of statistics.csv that the scene knows; it must outlive the table. */
    ColumnTable
    columns() const;

    /** Makes ready what these columns tell, after a step that was asked for sums. */
    void
    prepare_row();

    /** After a row: what counts from row to row begins anew. */
    void
    end_row();

    /** Lines for the log since this was called last. */
    std::vector<Notice>
    take_notices();

    parallel::PhaseTimer &
    timer()
    {
      return phase_timer;
    }

    /** Names and versions of the sections that save() gives. */
    std::vector<SectionTitle>
    titles() const;

    /**
     * All of the state but the particles, the same on all ranks. Brings this scene to the very state of
     * one that loads it: what is carried along otherwise, such as the mesh, the last potential and its
     * preconditioner, is built anew in both.
     */
    std::vector<Section>
    save();

    /**
     * In place of begin(): goes on from where save() was called.
     *
     * @param append_particles  adds the particles of the checkpoint to the bodies, in any order and
     *                          on any rank.
     */
    void
    load(const std::vector<Section> &sections,
         const std::function<void(std::vector<Body<dim>> &)> &append_particles);

  private:
    /** In the order in which they tell of themselves; each may ask those before it. */
    std::vector<Coupling *>
    couplings();

    std::vector<const Coupling *>
    couplings() const;

    void
    seed_bodies();

    /** Builds anew, from the particles alone: mesh, blocks, potential problem, order of the particles. */
    void
    set_up_decomposition();

    /** Brings particles to the ranks and slots of their blocks; adapts the mesh where they went. */
    void
    regroup_particles();

    /** The length of this step, and what limits it. */
    void
    choose_time_step(const double until);

    /** Mends the density of fluids, every few steps. */
    void
    relax_fluids();

    /** P2G of momentum and mass, summed over the ranks. */
    void
    transfer_to_lattice();

    /** Adds the impulse of surface tension to the momentum of the lattice. */
    void
    pull_surfaces();

    void
    update_lattice();

    /** G2P, with walls and rigid bodies. @return extremes over this rank's particles by body. */
    std::vector<ParticleExtremes>
    transfer_to_particles();

    /** The one exchange of a step: of its particles, its couplings, and its caller. */
    void
    reduce(const StepRequest &request, std::vector<ParticleExtremes> extremes);

    /** Finds the sums of this rank at @p time [s], of which the reduction makes those of all. */
    void
    add_sums(parallel::Reduction &reduction, const double time);

    /** Those of all ranks, of particles at the places where they are sorted to. */
    void
    find_sums();

    /** What limits the next step. @param extremes  over all particles, by body. */
    void
    find_limits(const std::vector<ParticleExtremes> &extremes);

    void
    add_particle_columns(ColumnTable &table) const;

    const Parameters<dim> parameters;
    const MPI_Comm communicator;
    parallel::PhaseTimer phase_timer;

    ExternalField<dim> external_field;
    MagneticCoupling<dim> magnetic;
    RigidBodyCoupling<dim> holder;
    FluidDensity<dim> fluids;
    SurfaceTension<dim> surfaces;
    BodyForces<dim> forces;

    std::unique_ptr<DomainDecomposition<dim>> decomposition;
    std::vector<Body<dim>> all_bodies;
    LatticeMotion<dim> lattice_motion;

    SceneState<dim> state;
  };
} // namespace magmpm
