#include <magmpm/base/number_text.h>
#include <magmpm/base/version.h>
#include <magmpm/coupling/artificial_attraction.h>
#include <magmpm/coupling/carried_force.h>
#include <magmpm/coupling/fluid_density.h>
#include <magmpm/coupling/magnetic_coupling.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/simulation/parameter_changes.h>
#include <magmpm/simulation/particle_reductions.h>
#include <magmpm/simulation/simulation.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Timer sections of a step, the verbs of the algorithm: columns of the statistics. */
    const std::vector<std::string> phases = {"Sort and migrate",
                                             "Solve potential",
                                             "Relax density",
                                             "P2G",
                                             "Update lattice",
                                             "G2P",
                                             "Statistics",
                                             "Output"};

    /** Particles are sorted again before any of them can have left the arena of its block. */
    constexpr double tolerated_drift = 0.99; // of dx

    template <int dim>
    double
    viscosity_over_density(const Body<dim> &body)
    {
      return std::visit([](const auto &law) { return law.viscosity() / law.density; },
                        body.material);
    }

    template <int dim>
    OpenFaces<dim>
    open_faces(const WallParameters<dim> &walls)
    {
      OpenFaces<dim> open;
      for (std::size_t face = 0; face < open.size(); ++face)
        open[face] = (walls.condition[face] == WallCondition::open);
      return open;
    }
  } // namespace

  template <int dim>
  Simulation<dim>::Simulation(const Parameters<dim> &parameters,
                              const MPI_Comm communicator,
                              const std::optional<Checkpoint> &checkpoint)
    : parameters(parameters)
    , communicator(communicator)
    , resumed(run_record_of(checkpoint))
    , results(parameters, phases, communicator, resumed ? &resumed->progress : nullptr)
    , external_field(parameters.sources)
    , rigid_bodies(this->parameters, external_field, communicator)
    , open(open_faces(parameters.walls))
    , time_step_control(parameters.time_step, parameters.lattice.spacing)
    , rest(parameters.rest)
    , checkpoints(communicator, parameters.output.directory, parameters.checkpoint.n_kept)
    , control(parameters.checkpoint, parameters.output.directory, parallel::rank(communicator))
    , attraction(parameters.attraction)
  {
    for (const BodyParameters<dim> &body : parameters.bodies)
      {
        bodies.emplace_back(body, parameters.material_of(body));
        typical_particle_mass = std::max(typical_particle_mass,
                                         body.density * body.particle_volume(parameters.lattice));
      }
    // Results have begun anew, or go on: an older checkpoint no longer belongs to them.
    if (checkpoint)
      restore(*checkpoint);
    else
      checkpoints.clear();
  }

  template <int dim>
  Simulation<dim>::~Simulation() = default;

  template <int dim>
  void
  Simulation<dim>::run()
  {
    try
      {
        if (!resumed)
          begin();
        while (!is_at_end() && !is_stopped())
          {
            advance_one_step();
            const bool frame_is_complete = rest.is_over(state) ||
                                           state.time >= (1. - 1e-9) * time_of_next_frame();
            if (frame_is_complete)
              {
                ++state.frame;
                write_frame();
              }
            if (checkpoint_is_due(frame_is_complete))
              write_checkpoint();
          }
      }
    catch (const std::exception &exception)
      {
        results.flush();
        results.log().failure(exception.what());
        throw;
      }
    timer.print(communicator, results.log().stream());
    if (is_stopped())
      results.log().message("stopped by " + RunControl::reason(request) +
                            "; go on with: magmpm --resume, and the same parameter file");
    else if (rest.is_over(state))
      results.log().message("ended since " + rest.reason());
    else
      results.log().message("ended at the end time");
    results.log().end();
  }

  template <int dim>
  double
  Simulation<dim>::time_of_next_frame() const
  {
    return std::min((state.frame + 1) * parameters.output.frame_interval, parameters.end_time);
  }

  template <int dim>
  bool
  Simulation<dim>::is_at_end() const
  {
    return rest.is_over(state) || state.time >= (1. - 1e-12) * parameters.end_time;
  }

  template <int dim>
  bool
  Simulation<dim>::is_stopped() const
  {
    return request > RunControl::Request::checkpoint;
  }

  template <int dim>
  bool
  Simulation<dim>::checkpoint_is_due(const bool frame_is_complete) const
  {
    const CheckpointParameters &wanted = parameters.checkpoint;
    if (wanted.every_n_frames > 0 && frame_is_complete && state.frame % wanted.every_n_frames == 0)
      return true;
    return request != RunControl::Request::none || (is_at_end() && wanted.is_wanted());
  }

  template <int dim>
  void
  Simulation<dim>::choose_time_step()
  {
    const TimeStep step =
      time_step_control.next_step(step_conditions, state.time, time_of_next_frame());
    state.time_step = step.length;
    state.limit     = step.limit;
    if (step.limit != frame_end_limit || state.step == 0)
      {
        state.full_time_step = step.length;
        state.full_limit     = step.limit;
      }
  }

  // One step, section 4.3 of Sun et al. 2021.
  template <int dim>
  void
  Simulation<dim>::advance_one_step()
  {
    choose_time_step();
    state.solved_this_step = false;

    rigid_bodies.set_time(state.time);
    update_magnetics(); // Eqs. (25)-(33)
    attract_bodies();
    relax_fluids();
    transfer_to_lattice(); // Eq. (28)
    update_lattice();      // Eqs. (33), (34)
    rigid_bodies.advance(state);
    transfer_to_particles(); // Eqs. (35)-(37)

    state.time += state.time_step;
    ++state.step;
    // Now, not before the next step: output also counts on particles being in their arenas.
    if (drift_since_sort > tolerated_drift * parameters.lattice.spacing)
      regroup_particles();
    check_for_rest();
    if (state.step % parameters.output.statistics_every == 0 || rest.is_over(state))
      write_statistics();
  }

  template <int dim>
  void
  Simulation<dim>::set_up_decomposition()
  {
    magnetics.reset(); // sees the mesh
    decomposition = std::make_unique<DomainDecomposition<dim>>(parameters, communicator);
    if (parameters.mesh.carries_potential && !(attraction.matches_magnets && state.attraction > 0.))
      magnetics = std::make_unique<MagneticCoupling<dim>>(
        parameters, *decomposition, external_field, timer, communicator);
    // Where particles are when a run begins or is resumed is no migration, and no change of the mesh.
    const std::size_t n_migrated = state.migrated_particles;
    const unsigned int n_changes = state.mesh_changes;
    regroup_particles();
    state.migrated_particles = n_migrated;
    state.mesh_changes       = n_changes;
  }

  template <int dim>
  void
  Simulation<dim>::seed_bodies()
  {
    const unsigned int rank    = parallel::rank(communicator);
    const unsigned int n_ranks = parallel::n_ranks(communicator);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        const BodyParameters<dim> &body = parameters.bodies[b];
        seed_particles(body, parameters.lattice, b, rank, n_ranks, bodies[b]);
        if (parallel::sum(bodies[b].particles.size(), communicator) == 0)
          throw InputError("body '" + body.name +
                           "' holds no particle: it is smaller than the distance between "
                           "particles. Make it larger, or 'Box/Cell size' smaller.");
      }
  }

  template <int dim>
  void
  Simulation<dim>::begin()
  {
    seed_bodies();
    set_up_decomposition();
    rigid_bodies.set_time(0.);
    step_conditions.acceleration = norm(parameters.gravity);
    update_magnetics();
    match_attraction();
    results.write_header(state, bodies);
    if (attraction.is_wanted())
      results.log().message(description(attraction));

    // What limits the first step is not known from a step before it.
    std::vector<ParticleExtremes> extremes;
    for (const ParticleSums<dim> &sums : sums_over_ranks(bodies, parameters, communicator))
      {
        const Body<dim> &body = bodies[extremes.size()];
        extremes.push_back({sums.max_speed,
                            sums.max_speed + undeformed_wave_speed(body),
                            sums.max_affine_velocity,
                            1.,
                            1.});
      }
    update_step_conditions(extremes);
    write_statistics();
    write_frame();
  }

  template <int dim>
  void
  Simulation<dim>::regroup_particles()
  {
    const parallel::PhaseTimer::Scope timed(timer, "Sort and migrate");
    const auto regrouping = decomposition->regroup(bodies);
    if (regrouping.n_lost > 0)
      {
        const std::string text = report(regrouping, state.time);
        if (!parameters.walls.removes_leaving_particles)
          throw RunError(text + " Take a larger box, another condition than open for this face, or "
                                "'Particles leaving the box = remove' in the section 'Walls'.");
        results.log().warning(text);
      }
    state.lost_particles += regrouping.n_lost;
    state.migrated_particles += regrouping.n_migrated;
    if (regrouping.mesh.is_rebalanced)
      results.log().rebalanced(regrouping.mesh.imbalance_before, regrouping.mesh.imbalance);
    state.mesh_changes += regrouping.mesh.is_change();
    state.imbalance = regrouping.mesh.imbalance;
    lattice_field.reinit(decomposition->blocks().size());
    drift_since_sort = 0.;
  }

  template <int dim>
  void
  Simulation<dim>::relax_fluids()
  {
    if (!has_fluid(bodies) || state.step % relaxation_period != 0)
      return;
    const parallel::PhaseTimer::Scope timed(timer, "Relax density");
    // P2G fills the lattice field anew after this.
    state.density_error = relax_density(relaxation_period * state.time_step,
                                        decomposition->partition(),
                                        parameters.lattice,
                                        open,
                                        communicator,
                                        lattice_field,
                                        bodies);
  }

  template <int dim>
  void
  Simulation<dim>::match_attraction()
  {
    if (!attraction.matches_magnets)
      return;
    state.attraction = attraction.acceleration =
      matched_acceleration(parameters, bodies, communicator);
    magnetics.reset();
    for (Body<dim> &body : bodies)
      drop_carried_force(body);
    state.last_solve.energy             = 0.;
    step_conditions.magnetic_wave_speed = 0.;
    step_conditions.acceleration        = norm(parameters.gravity);
  }

  template <int dim>
  void
  Simulation<dim>::attract_bodies()
  {
    if (!attraction.is_wanted())
      return;
    double largest = 0.;
    for (Body<dim> &body : bodies)
      largest = std::max(largest, attract(attraction, state.time_step, body));
    step_conditions.attraction = parallel::max(largest, communicator);
  }

  template <int dim>
  void
  Simulation<dim>::check_for_rest()
  {
    if (!rest.is_due(state))
      return;
    ParticleSums<dim> total;
    for (const ParticleSums<dim> &sums : sums_over_ranks(bodies, parameters, communicator))
      total += sums;
    rest.note_speed(2. * total.kinetic_energy / total.mass, state);
  }

  template <int dim>
  void
  Simulation<dim>::update_magnetics()
  {
    if (magnetics == nullptr)
      return;
    magnetics->advance_force(bodies, state);
    if (!magnetics->is_due(bodies, state))
      return;
    const parallel::PhaseTimer::Scope timed(timer, "Solve potential");
    magnetics->solve(bodies, state); // Eqs. (25)-(33)
    state.rigid_bodies_at_solve         = rigid_bodies.bodies().record();
    step_conditions.magnetic_wave_speed = 0.;
    step_conditions.acceleration        = norm(parameters.gravity);
    for (const ParticleSums<dim> &sums : sums_over_ranks(bodies, parameters, communicator))
      {
        step_conditions.magnetic_wave_speed = std::max(step_conditions.magnetic_wave_speed,
                                                       sums.max_magnetic_wave_speed);
        step_conditions.acceleration        = std::max(
          step_conditions.acceleration, norm(parameters.gravity) + sums.max_magnetic_acceleration);
      }
  }

  template <int dim>
  void
  Simulation<dim>::transfer_to_lattice()
  {
    const parallel::PhaseTimer::Scope timed(timer, "P2G");
    particles_to_lattice(
      bodies, decomposition->blocks(), parameters.lattice, state.time_step, lattice_field);
    decomposition->partition().add_ghosts_to_owners(lattice_field);
  }

  template <int dim>
  void
  Simulation<dim>::update_lattice()
  {
    const parallel::PhaseTimer::Scope timed(timer, "Update lattice");
    rigid_bodies.update_lattice(
      decomposition->blocks(), typical_particle_mass, state, lattice_field);
    decomposition->partition().update_ghosts(lattice_field);
  }

  template <int dim>
  void
  Simulation<dim>::transfer_to_particles()
  {
    const parallel::PhaseTimer::Scope timed(timer, "G2P");
    std::vector<ParticleExtremes> extremes = lattice_to_particles(
      lattice_field, decomposition->blocks(), parameters.lattice, state.time_step, bodies);
    drift_since_sort += rigid_bodies.hold_particles(decomposition->blocks(), open, bodies, state);

    request = static_cast<RunControl::Request>(
      maximize_over_ranks(extremes, static_cast<double>(control.request()), communicator));
    double speed = 0.;
    for (const ParticleExtremes &e : extremes)
      speed = std::max(speed, e.speed);
    drift_since_sort += state.time_step * speed;
    state.drift_since_solve += state.time_step * speed;
    state.path_since_solve += state.time_step * speed;
    state.max_speed = speed;
    check_for_runaways(bodies, extremes, parameters.runaway_limits, state, communicator);
    update_step_conditions(extremes);
  }

  template <int dim>
  void
  Simulation<dim>::update_step_conditions(const std::vector<ParticleExtremes> &extremes)
  {
    StepConditions &conditions = step_conditions;
    rigid_bodies.update_step_conditions(state, conditions);
    conditions.signal_speed        = 0.;
    conditions.affine_velocity     = 0.;
    conditions.kinematic_viscosity = 0.;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        conditions.signal_speed    = std::max(conditions.signal_speed, extremes[b].signal_speed);
        conditions.affine_velocity = std::max(conditions.affine_velocity,
                                              extremes[b].affine_velocity);
        conditions.kinematic_viscosity =
          std::max(conditions.kinematic_viscosity,
                   extremes[b].max_volume_ratio * viscosity_over_density(bodies[b]));
      }
  }

  template <int dim>
  void
  Simulation<dim>::write_frame()
  {
    const parallel::PhaseTimer::Scope timed(timer, "Output");
    if (state.frame > 0)
      results.report_frame(state);
    results.write_particles(state, bodies);
    results.write_surface(state, bodies);
    if (results.writes_fields())
      {
        // The mesh may have changed since the last solve: then the potential is found anew. The
        // force that particles carry stays: output changes a run by no more than where the next
        // Newton iteration starts, within its tolerance.
        magnetics->solve_for_output(bodies, state);
        results.write_fields(state, magnetics->potential(), external_field);
      }
    // Where the next step finds them.
    rigid_bodies.set_time(state.time);
    results.write_rigid_bodies(state, external_field, rigid_bodies.bodies());
    results.flush();
  }

  template <int dim>
  void
  Simulation<dim>::write_statistics()
  {
    const parallel::PhaseTimer::Scope timed(timer, "Statistics");
    double n_particles = 0.;
    for (const Body<dim> &body : bodies)
      n_particles += static_cast<double>(body.particles.size());
    if (magnetics != nullptr)
      magnetics->update_reactions(state);
    results.write_statistics(state,
                             sums_over_ranks(bodies, parameters, communicator),
                             parallel::min(n_particles, communicator),
                             timer.seconds(),
                             rigid_bodies.bodies(),
                             rigid_bodies.forces_on_magnets(state));
    state.deepest_penetration = 0.;
  }

  template <int dim>
  void
  Simulation<dim>::write_checkpoint()
  {
    const parallel::PhaseTimer::Scope timed(timer, "Checkpoint");
    // The run goes on as a run resumed from here will.
    set_up_decomposition();
    const RunRecord record = {state, step_conditions, results.progress()};
    try
      {
        checkpoints.write("step-" + with_digits(state.step, 10),
                          make_checkpoint(record, parameters.complete_text, bodies));
      }
    catch (const RunError &error)
      {
        // A run that has room to go on does so; one that ends here would lose everything.
        if (is_stopped())
          throw;
        results.log().warning(error.what());
      }
    control.restart_interval();
    control.clear_stop_file();
  }

  template <int dim>
  void
  Simulation<dim>::restore(const Checkpoint &checkpoint)
  {
    const std::string changes = check_resumable(parameters.complete_text, checkpoint.parameters);

    state           = resumed->state;
    step_conditions = resumed->step_conditions;
    if (attraction.matches_magnets)
      attraction.acceleration = state.attraction;
    for (std::size_t b = 0; b < checkpoint.particles.size(); ++b)
      bodies[b].particles.append_from_records(checkpoint.particles[b]);
    rigid_bodies.restore(state.rigid_bodies_at_solve);
    external_field.set_time(state.time_of_last_solve);
    external_field.remember();
    rigid_bodies.restore(state.rigid_bodies);
    set_up_decomposition();

    results.write_header(state, bodies);
    results.log().message("resumed at frame " + std::to_string(state.frame) +
                          ", t = " + three_digits(state.time) + " s, from " + checkpoints.latest());
    if (!changes.empty())
      results.log().message("parameters changed since the checkpoint:" + changes);
    if (checkpoint.version != version_string())
      results.log().warning("the checkpoint was written by another program: " + checkpoint.version);
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace magmpm
