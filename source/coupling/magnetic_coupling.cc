#include <magmpm/coupling/carried_force.h>
#include <magmpm/coupling/extrapolation.h>
#include <magmpm/coupling/force_moments.h>
#include <magmpm/coupling/magnetic_coupling.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/magnetics/source_reaction.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/magnetic_transfer.h>
#include <magmpm/particles/particle_sums.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace magmpm
{
  template <int dim>
  MagneticCoupling<dim>::MagneticCoupling(const MagneticCouplingParameters<dim> &parameters,
                                          ExternalField<dim> &external_field,
                                          parallel::PhaseTimer &timer,
                                          const MPI_Comm communicator)
    : parameters(parameters)
    , external_field(external_field)
    , timer(timer)
    , communicator(communicator)
  {
  }

  template <int dim>
  MagneticCoupling<dim>::~MagneticCoupling() = default;

  template <int dim>
  void
  MagneticCoupling<dim>::set_up(const BackgroundMesh<dim> &new_mesh,
                                const BlockPartition<dim> &new_partition)
  {
    reset();
    if (memory.is_over)
      return;
    mesh      = &new_mesh;
    partition = &new_partition;
    problem =
      std::make_unique<PotentialProblem<dim>>(new_mesh, new_partition, parameters.magnetics, timer);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::reset()
  {
    problem.reset();
    mesh_of_last_solve.reset();
    mesh      = nullptr;
    partition = nullptr;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::update(const Clock &clock, std::vector<Body<dim>> &bodies)
  {
    work                    = 0.;
    memory.solved_this_step = false;
    if (!is_active())
      return;
    advance_force(bodies);
    update_age(bodies);
    if (is_due(clock))
      solve(clock, way_of_force(), bodies);
    else if (has_stopped(clock, bodies))
      solve(clock, 0., bodies);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::note_motion(const double way)
  {
    memory.age.drift += way;
    memory.age.path += way;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::find_work(const std::vector<Body<dim>> &bodies)
  {
    for (const Body<dim> &body : bodies)
      work += work_since_solve(memory.age.carried_way, body);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::reduce(parallel::Reduction &reduction)
  {
    reduction.sum(work);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::end(std::vector<Body<dim>> &bodies)
  {
    reset();
    for (Body<dim> &body : bodies)
      drop_carried_force(body);
    memory.is_over          = true;
    memory.report.energy    = 0.;
    memory.max_wave_speed   = 0.;
    memory.max_acceleration = 0.;
  }

  template <int dim>
  double
  MagneticCoupling<dim>::way_of_force() const
  {
    if (memory.n_solves == 0)
      return 0.;
    return memory.age.path + change_of_sources();
  }

  template <int dim>
  double
  MagneticCoupling<dim>::change_of_sources() const
  {
    // A source that changes in strength by all of itself counts as one that moves by dx.
    const auto change = external_field.change_since_remembered();
    return change.displacement + change.relative_strength * parameters.lattice.spacing;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::advance_force(std::vector<Body<dim>> &bodies)
  {
    if (memory.n_solves == 0)
      return;
    // By parts of a way that change no force by more than a few per mille: this goes through all particles.
    constexpr double shortest = 0.005; // of dx
    const double way          = way_of_force();
    if (std::abs(way - memory.age.carried_way) < shortest * parameters.lattice.spacing)
      return;
    for (Body<dim> &body : bodies)
      advance_carried_force(way - memory.age.carried_way, body);
    memory.reactions.advance(way - memory.age.carried_way);
    memory.age.carried_way = way;
  }

  template <int dim>
  double
  MagneticCoupling<dim>::tolerated_share() const
  {
    // Without a rate, as after the first solve, the next one comes soon.
    return memory.interval.has_rate ? memory.interval.share : std::min(memory.interval.share, 0.2);
  }

  template <int dim>
  double
  MagneticCoupling<dim>::tolerated_drift() const
  {
    return tolerated_share() * parameters.trigger.moved_fraction * parameters.lattice.spacing;
  }

  template <int dim>
  double
  MagneticCoupling<dim>::taken_share() const
  {
    const auto over = [](const double change, const double tolerated) {
      return tolerated > 0. ? change / tolerated : 1.;
    };
    const auto change = external_field.change_since_remembered();
    const double way  = std::max(memory.age.drift, change.displacement);
    return std::max(over(way, parameters.trigger.moved_fraction * parameters.lattice.spacing),
                    over(change.relative_strength, parameters.trigger.changed_fraction));
  }

  template <int dim>
  void
  MagneticCoupling<dim>::find_drift(const std::vector<Body<dim>> &bodies)
  {
    double drift = 0.;
    for (const Body<dim> &body : bodies)
      drift = std::max(drift, way_since_solve(body));
    memory.age.drift = parallel::max(drift, communicator);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::update_age(std::vector<Body<dim>> &bodies)
  {
    // The sum of the steps is cheap to have and never too short; vibrations make it too long.
    if (memory.n_solves == 0 || memory.age.drift <= tolerated_drift() ||
        parameters.trigger.trigger != SolveTriggerParameters::Trigger::when_changed)
      return;
    find_drift(bodies);
    if (memory.age.drift > tolerated_drift() || memory.age.drift > 0.5 * memory.age.path)
      return;
    // A motion that turned back is a vibration: its way says nothing about the force.
    for (Body<dim> &body : bodies)
      freeze_carried_force(memory.age.carried_way, body);
    memory.reactions.freeze();
  }

  template <int dim>
  bool
  MagneticCoupling<dim>::is_due(const Clock &clock) const
  {
    using Trigger = SolveTriggerParameters::Trigger;
    if (memory.n_solves == 0)
      return true;
    if (memory.step_of_solve == clock.step)
      return false;
    switch (parameters.trigger.trigger)
      {
        case Trigger::every_step:
          return true;
        case Trigger::every_n_steps:
          return clock.step % parameters.trigger.n_steps == 0;
        default:
          const auto change = external_field.change_since_remembered();
          return memory.age.drift > tolerated_drift() || change.displacement > tolerated_drift() ||
                 change.relative_strength > tolerated_share() * parameters.trigger.changed_fraction;
      }
  }

  template <int dim>
  bool
  MagneticCoupling<dim>::has_stopped(const Clock &clock, const std::vector<Body<dim>> &bodies)
  {
    constexpr double noticeable = 1e-3; // of dx
    constexpr double hardly     = 1.5;  // times the change at the look before
    SolveInterval &interval     = memory.interval;
    if (parameters.trigger.trigger != SolveTriggerParameters::Trigger::when_changed ||
        clock.time - memory.time_of_solve < interval.next_look)
      return false;
    interval.next_look = 2. * std::max(interval.next_look, clock.time_step);
    find_drift(bodies);
    const double change = memory.age.drift + change_of_sources();
    const double before = std::exchange(interval.change_at_look, change);
    return change > noticeable * parameters.lattice.spacing && change < hardly * before;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::solve(const Clock &clock, const double way, std::vector<Body<dim>> &bodies)
  {
    const parallel::PhaseTimer::Scope timed(timer, "Solve potential");
    solve_potential(bodies);
    find_force(way, bodies);
    NodeField<dim, SingleVector> field;
    problem->compute_field(field);
    interpolate_to_particles(
      field, partition->blocks(), parameters.lattice, ParticleProperty::magnetic_field, bodies);

    for (Body<dim> &body : bodies)
      remember_positions(body);
    memory.reactions.note_solve(way_of_force());
    memory.interval = {way > 0., memory.interval.share, clock.time - memory.time_of_solve, 0.};
    external_field.remember();
    memory.age              = {};
    memory.solved_this_step = true;
    memory.step_of_solve    = clock.step;
    memory.time_of_solve    = clock.time;
    ++memory.n_solves;
    // What moves a free magnet is needed now, what is only told of magnets when a row is written.
    if (parameters.moves_magnets)
      find_reactions(memory.interval.has_rate);
    find_limits(bodies);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::solve_for_output(std::vector<Body<dim>> &bodies)
  {
    if (mesh_of_last_solve != mesh->revision())
      solve_potential(bodies);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::solve_potential(std::vector<Body<dim>> &bodies)
  {
    memory.report      = problem->solve(magnetic_content(bodies), external_field);
    mesh_of_last_solve = mesh->revision();
  }

  template <int dim>
  NodeField<dim, NodeContent>
  MagneticCoupling<dim>::magnetic_content(std::vector<Body<dim>> &bodies) const
  {
    NodeField<dim, NodeContent> content(partition->blocks().size());
    magnetic_content_to_lattice(bodies, partition->blocks(), parameters.lattice, content);
    partition->add_ghosts_to_owners(content, Parity());
    partition->update_ghosts(content);
    return content;
  }

  template <int dim>
  NodeField<dim, SingleScalar>
  MagneticCoupling<dim>::taking_masses(const NodeField<dim, SingleScalar> &masses) const
  {
    constexpr double heavy      = 0.9; // of the heaviest node around
    constexpr auto mass         = SingleScalar::value;
    const BlockSet<dim> &blocks = partition->blocks();
    NodeField<dim, SingleScalar> taking(masses);
    if (parameters.thin_mass == 0.)
      return taking;
    for_nodes(blocks, [&](const int slot, const int n) {
      const double own = masses.get(mass, slot, n);
      double most      = 0.;
      if (own > 0.)
        for_nodes_around(blocks, slot, n, [&](const int other_slot, const int other) {
          most = std::max(most, masses.get(mass, other_slot, other));
        });
      if (most < parameters.thin_mass && own < heavy * most)
        taking.set(mass, slot, n, 0.);
    });
    partition->update_ghosts(taking);
    return taking;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::find_force(const double way, std::vector<Body<dim>> &bodies)
  {
    // Only magnetic particles carry the force, so nodes give it to the mass of these alone.
    const BlockSet<dim> &blocks = partition->blocks();
    NodeField<dim, SingleScalar> masses(blocks.size());
    NodeField<dim, SingleVector> force;
    magnetic_mass_to_lattice(bodies, blocks, parameters.lattice, masses);
    partition->add_ghosts_to_owners(masses, Parity());
    partition->update_ghosts(masses);
    memory.dropped_force = problem->compute_force(taking_masses(masses), force);

    const ForceMoments<dim> carried = force_moments(bodies, parameters.lattice, communicator);
    for (Body<dim> &body : bodies)
      recall_carried_force(memory.age.carried_way, body);
    carry_force(*partition, parameters.lattice, masses, force, bodies);
    for (Body<dim> &body : bodies)
      set_rate_of_carried_force(way, body);
    if (way > 0.)
      memory.interval.share = next_share(
        memory.interval.share,
        taken_share(),
        relative_difference(carried, force_moments(bodies, parameters.lattice, communicator)),
        parameters.trigger.force_tolerance);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::find_reactions(const bool has_rate)
  {
    memory.reactions.set(
      reactions_on_sources(problem->material_samples(), external_field, communicator), has_rate);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::prepare_row()
  {
    if (is_active() && !memory.reactions.are_of_last_solve() && !external_field.sources().empty() &&
        mesh_of_last_solve == mesh->revision())
      // Later the sources may have moved since the solve, and a rate would count that twice.
      find_reactions(memory.solved_this_step && memory.interval.has_rate);
  }

  template class MagneticCoupling<2>;
  template class MagneticCoupling<3>;
} // namespace magmpm
