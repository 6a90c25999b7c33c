#include <magmpm/simulation/runaway_check.h>
#include <magmpm/simulation/scene.h>
#include <magmpm/simulation/time_step_control.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    using Scope = parallel::PhaseTimer::Scope;

    /** Of a full cell: where no node has as much material is thin. */
    constexpr double thin_share = 0.25;

    template <int dim>
    MagneticCouplingParameters<dim>
    magnetic_part(const Parameters<dim> &parameters)
    {
      const bool moves_magnets = std::any_of(parameters.magnet_bodies.begin(),
                                             parameters.magnet_bodies.end(),
                                             [](const auto &magnet) { return magnet.is_free; });
      double full_cell         = 0.; // of fluids that would spray
      for (const BodyParameters<dim> &body : parameters.bodies)
        if (parameters.material_of(body).surface_tension > 0.)
          full_cell = std::max(full_cell, body.density * std::pow(parameters.lattice.spacing, dim));
      return {parameters.lattice,
              parameters.magnetics,
              parameters.solve_trigger,
              moves_magnets,
              thin_share * full_cell};
    }

    template <int dim>
    RigidBodyCouplingParameters<dim>
    rigid_part(const Parameters<dim> &parameters)
    {
      return {parameters.lattice,
              parameters.walls,
              parameters.gravity,
              parameters.sources,
              parameters.magnet_bodies,
              parameters.rigid_bodies,
              parameters.contact_groups()};
    }
  } // namespace

  template <int dim>
  const std::vector<std::string> Scene<dim>::phases = {"Sort and migrate",
                                                       "Solve potential",
                                                       "Relax density",
                                                       "P2G",
                                                       "Surface tension",
                                                       "Update lattice",
                                                       "G2P",
                                                       "Statistics",
                                                       "Output"};

  template <int dim>
  Scene<dim>::Scene(const Parameters<dim> &scene_parameters, const MPI_Comm communicator)
    : parameters(scene_parameters)
    , communicator(communicator)
    , external_field(parameters.sources)
    , magnetic(magnetic_part(parameters), external_field, phase_timer, communicator)
    , holder(rigid_part(parameters), external_field, magnetic.state().reactions, communicator)
    , fluids(parameters.lattice, parameters.walls.open_faces())
    , surfaces(parameters.lattice, parameters.walls)
    , forces(parameters.forces)
    , lattice_motion(parameters, communicator)
  {
    for (const BodyParameters<dim> &body : parameters.bodies)
      all_bodies.emplace_back(body, parameters.material_of(body));
  }

  template <int dim>
  Scene<dim>::~Scene() = default;

  template <int dim>
  std::vector<const Coupling *>
  Scene<dim>::couplings() const
  {
    std::vector<const Coupling *> couplings = {&magnetic, &holder, &fluids, &surfaces};
    for (const auto &force : forces.all())
      couplings.push_back(force.get());
    return couplings;
  }

  template <int dim>
  std::vector<Coupling *>
  Scene<dim>::couplings()
  {
    std::vector<Coupling *> couplings = {&magnetic, &holder, &fluids, &surfaces};
    for (const auto &force : forces.all())
      couplings.push_back(force.get());
    return couplings;
  }

  template <int dim>
  void
  Scene<dim>::begin()
  {
    seed_bodies();
    set_up_decomposition();
    holder.set_time(0.);
    magnetic.update(state.clock, all_bodies);
    find_sums();
    forces.begin(total().magnetic_force, all_bodies, communicator);
    if (forces.replace_magnets())
      {
        magnetic.end(all_bodies);
        find_sums();
      }
    for (const Coupling *coupling : couplings())
      if (!coupling->description().empty())
        state.notices.push_back({false, coupling->description()});

    // What limits the first step is not known from a step before it.
    std::vector<ParticleExtremes> extremes;
    for (const ParticleSums<dim> &sums : state.sums)
      extremes.push_back({sums.max_speed,
                          sums.max_speed + undeformed_wave_speed(all_bodies[extremes.size()]),
                          sums.max_affine_velocity,
                          1.,
                          1.});
    find_limits(extremes);
  }

  // One step, section 4.3 of Sun et al. 2021.
  template <int dim>
  void
  Scene<dim>::step(const StepRequest &request)
  {
    choose_time_step(request.until);
    holder.set_time(state.clock.time);
    magnetic.update(state.clock, all_bodies); // Eqs. (25)-(33)
    forces.act(state.clock, all_bodies);
    relax_fluids();
    transfer_to_lattice(); // Eq. (28)
    pull_surfaces();
    update_lattice(); // Eqs. (33), (34)
    holder.advance(state.clock);
    reduce(request, transfer_to_particles()); // Eqs. (35)-(37)

    state.clock.time += state.clock.time_step;
    ++state.clock.step;
    // Now, not before the next step: output also counts on particles being in their arenas.
    const bool is_due = decomposition->regrouping_is_due();
    if (is_due)
      regroup_particles();
    if (request.wants_sums && (is_due || lattice_motion.smooths_volume()))
      find_sums();
  }

  template <int dim>
  void
  Scene<dim>::choose_time_step(const double until)
  {
    const TimeStep step = TimeStepControl(parameters.time_step, parameters.lattice.spacing)
                            .next_step(state.conditions, state.clock.time, until);
    state.clock.time_step = step.length;
    state.limit           = step.limit;
    if (step.limit != frame_end_limit || state.clock.step == 0)
      state.last_full_step = step;
  }

  template <int dim>
  void
  Scene<dim>::relax_fluids()
  {
    const Scope timed(phase_timer, "Relax density");
    fluids.relax(state.clock, decomposition->partition(), holder.bodies().all(), all_bodies);
  }

  template <int dim>
  void
  Scene<dim>::transfer_to_lattice()
  {
    const Scope timed(phase_timer, "P2G");
    lattice_motion.sum_momentum(decomposition->partition(), state.clock.time_step, all_bodies);
    holder.find_contact(decomposition->partition(), all_bodies);
  }

  template <int dim>
  void
  Scene<dim>::pull_surfaces()
  {
    const Scope timed(phase_timer, "Surface tension");
    // Fluids are in group 0, the lowest.
    surfaces.act(state.clock,
                 decomposition->partition(),
                 holder.bodies().all(),
                 all_bodies,
                 lattice_motion.by_group().front().motion);
  }

  template <int dim>
  void
  Scene<dim>::update_lattice()
  {
    const Scope timed(phase_timer, "Update lattice");
    lattice_motion.update_velocity(state.clock,
                                   decomposition->partition(),
                                   holder.lattice_boundary(),
                                   all_bodies,
                                   holder.contacts());
    if (state.clock.step == 0)
      for (const std::string &overlap : lattice_motion.contact().find_overlaps(all_bodies))
        state.notices.push_back({true, overlap});
    holder.collide(state.clock,
                   decomposition->partition(),
                   has_fluid(all_bodies),
                   lattice_motion.typical_mass(),
                   lattice_motion.by_group());
    lattice_motion.finish(decomposition->partition(), state.clock.time_step, all_bodies);
  }

  template <int dim>
  std::vector<ParticleExtremes>
  Scene<dim>::transfer_to_particles()
  {
    const Scope timed(phase_timer, "G2P");
    std::vector<ParticleExtremes> extremes =
      lattice_motion.move_particles(decomposition->partition(), state.clock.time_step, all_bodies);
    holder.hold_particles(decomposition->blocks(), parameters.walls.open_faces(), all_bodies);
    holder.note_contact(lattice_motion.contact().energy(), lattice_motion.contact().depth());
    return extremes;
  }

  template <int dim>
  void
  Scene<dim>::reduce(const StepRequest &request, std::vector<ParticleExtremes> extremes)
  {
    const Scope timed(phase_timer, "G2P");
    parallel::Reduction reduction;
    for (ParticleExtremes &e : extremes)
      reduction.max(e);
    if (request.wants_sums)
      magnetic.find_work(all_bodies);
    for (Coupling *coupling : couplings())
      coupling->reduce(reduction);
    if (request.wants_sums)
      add_sums(reduction, state.clock.time + state.clock.time_step);
    if (request.reduce_along)
      request.reduce_along(reduction);
    reduction.carry_out(communicator);
    for (Coupling *coupling : couplings())
      coupling->take_reduced();

    state.max_speed = 0.;
    for (const ParticleExtremes &e : extremes)
      state.max_speed = std::max(state.max_speed, e.speed);
    const double way = state.clock.time_step * state.max_speed;
    decomposition->note_motion(way + holder.longest_push());
    magnetic.note_motion(way);
    check_for_runaways(
      all_bodies, extremes, parameters.runaway_limits, state.clock, state.limit, communicator);
    find_limits(extremes);
  }

  template <int dim>
  void
  Scene<dim>::find_limits(const std::vector<ParticleExtremes> &extremes)
  {
    StepConditions conditions;
    conditions.acceleration =
      norm(parameters.gravity(state.clock.time + state.clock.time_step)); // when that step begins
    conditions.rigid_acceleration = conditions.acceleration;
    for (std::size_t b = 0; b < all_bodies.size(); ++b)
      {
        const ParticleExtremes &e = extremes[b];
        const double viscosity    = std::visit(
          [](const auto &law) { return law.viscosity() / law.density; }, all_bodies[b].material);
        conditions.signal_speed        = std::max(conditions.signal_speed, e.signal_speed);
        conditions.affine_velocity     = std::max(conditions.affine_velocity, e.affine_velocity);
        conditions.kinematic_viscosity = std::max(conditions.kinematic_viscosity,
                                                  e.max_volume_ratio * viscosity);
      }
    for (const Coupling *coupling : couplings())
      coupling->limit_step(conditions);
    state.conditions = conditions;
  }

  template class Scene<2>;
  template class Scene<3>;
} // namespace magmpm
