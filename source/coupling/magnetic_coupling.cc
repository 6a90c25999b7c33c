#include <magmpm/coupling/carried_force.h>
#include <magmpm/coupling/carried_reaction.h>
#include <magmpm/coupling/magnetic_coupling.h>
#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/magnetics/source_reaction.h>
#include <magmpm/mesh/mirror_images.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/magnetic_transfer.h>
#include <magmpm/particles/particle_sums.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  MagneticCoupling<dim>::MagneticCoupling(const Parameters<dim> &parameters,
                                          const DomainDecomposition<dim> &decomposition,
                                          ExternalField<dim> &external_field,
                                          parallel::PhaseTimer &timer,
                                          const MPI_Comm communicator)
    : parameters(parameters)
    , decomposition(decomposition)
    , external_field(external_field)
    , communicator(communicator)
    , problem(std::make_unique<PotentialProblem<dim>>(decomposition.mesh(),
                                                      decomposition.partition(),
                                                      parameters.magnetics,
                                                      timer))
  {
  }

  template <int dim>
  MagneticCoupling<dim>::~MagneticCoupling() = default;

  template <int dim>
  bool
  MagneticCoupling<dim>::is_due(std::vector<Body<dim>> &bodies, RunState &state) const
  {
    using Trigger                         = SolveTriggerParameters::Trigger;
    const SolveTriggerParameters &trigger = parameters.solve_trigger;
    if (state.n_solves == 0)
      return true;
    if (state.step_of_last_solve == state.step)
      return false;
    if (trigger.trigger == Trigger::every_step)
      return true;
    if (trigger.trigger == Trigger::every_n_steps)
      return state.step % trigger.n_steps == 0;
    // After the first solve the rate of the force is not known yet: the second one comes soon.
    const double tolerated = (state.n_solves == 1 ? 0.5 : 1.) * trigger.moved_fraction *
                             parameters.lattice.spacing;
    // The sum of the steps is cheap to have and never too short; vibrations make it too long.
    if (state.drift_since_solve > tolerated)
      {
        state.drift_since_solve = 0.;
        for (const Body<dim> &body : bodies)
          state.drift_since_solve = std::max(state.drift_since_solve, way_since_solve(body));
        state.drift_since_solve = parallel::max(state.drift_since_solve, communicator);
        // A motion that turned back is a vibration: its way says nothing about the force.
        if (state.drift_since_solve <= tolerated)
          {
            for (Body<dim> &body : bodies)
              hold_carried_force(state.carried_way, body);
            hold_reactions(state.carried_way, state.reactions);
          }
      }
    const auto change = external_field.change_since_remembered();
    return state.drift_since_solve > tolerated || change.displacement > tolerated ||
           change.relative_strength > trigger.changed_fraction;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::solve(std::vector<Body<dim>> &bodies, RunState &state)
  {
    solve_potential(bodies, state);
    const double way = state.carried_way;
    carry_force(nodal_accelerations(bodies, state), bodies, state);
    NodeField<dim> field;
    field.reinit(decomposition.blocks().size());
    problem->compute_field(field);
    interpolate_to_particles(
      field, decomposition.blocks(), parameters.lattice, ParticleProperty::magnetic_field, bodies);

    for (Body<dim> &body : bodies)
      remember_positions(body);
    external_field.remember();
    state.drift_since_solve  = 0.;
    state.solved_this_step   = true;
    state.step_of_last_solve = state.step;
    state.time_of_last_solve = state.time;
    ++state.n_solves;
    // What moves a free magnet is needed now, what is only told of magnets when a row is written.
    if (std::any_of(parameters.sources.begin(), parameters.sources.end(), [](const auto &source) {
          return source.is_free;
        }))
      find_reactions(way, state);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::find_reactions(const double way, RunState &state) const
  {
    set_reactions(reactions_on_sources(problem->material_samples(), external_field, communicator),
                  way,
                  state.reactions);
    state.reactions.n_solves = state.n_solves;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::update_reactions(RunState &state) const
  {
    if (state.reactions.n_solves != state.n_solves && !parameters.sources.empty() &&
        mesh_of_last_solve == decomposition.mesh().revision())
      find_reactions(0., state);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::advance_force(std::vector<Body<dim>> &bodies, RunState &state) const
  {
    if (state.n_solves == 0)
      return;
    // A source that changes in strength by all of itself counts as one that moves by dx.
    const auto change = external_field.change_since_remembered();
    const double way  = state.path_since_solve + change.displacement +
                       change.relative_strength * parameters.lattice.spacing;
    for (Body<dim> &body : bodies)
      advance_carried_force(way - state.carried_way, body);
    advance_reactions(way - state.carried_way, state.reactions);
    state.carried_way = way;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::solve_for_output(std::vector<Body<dim>> &bodies, RunState &state)
  {
    if (mesh_of_last_solve != decomposition.mesh().revision())
      solve_potential(bodies, state);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::solve_potential(std::vector<Body<dim>> &bodies, RunState &state)
  {
    state.last_solve   = problem->solve(magnetic_content(bodies), external_field);
    mesh_of_last_solve = decomposition.mesh().revision();
  }

  template <int dim>
  NodeField<dim>
  MagneticCoupling<dim>::magnetic_content(std::vector<Body<dim>> &bodies) const
  {
    NodeField<dim> content;
    content.reinit(decomposition.blocks().size());
    magnetic_content_to_lattice(bodies, decomposition.blocks(), parameters.lattice, content);
    decomposition.partition().add_ghosts_to_owners(content);
    decomposition.partition().update_ghosts(content);
    return content;
  }

  template <int dim>
  NodeField<dim>
  MagneticCoupling<dim>::nodal_accelerations(std::vector<Body<dim>> &bodies, RunState &state) const
  {
    // Only magnetic particles carry the force, so nodes give it to the mass of these alone.
    const BlockSet<dim> &blocks = decomposition.blocks();
    NodeField<dim> masses, force;
    masses.reinit(blocks.size());
    force.reinit(blocks.size());
    magnetic_mass_to_lattice(bodies, blocks, parameters.lattice, masses);
    decomposition.partition().add_ghosts_to_owners(masses);
    decomposition.partition().update_ghosts(masses);
    add_mirror_images(
      decomposition.partition(), parameters.lattice, parameters.magnetics.shielded, masses);
    state.dropped_magnetic_force = norm(problem->compute_force(masses, force));
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          double *node      = force.node(slot, n);
          const double mass = masses.node(slot, n)[3];
          for (int d = 0; d < dim; ++d)
            node[d] = (mass > 0. ? node[d] / mass : 0.);
        }
    decomposition.partition().update_ghosts(force);
    return force;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::carry_force(const NodeField<dim> &accelerations,
                                     std::vector<Body<dim>> &bodies,
                                     RunState &state) const
  {
    for (Body<dim> &body : bodies)
      recall_carried_force(state.carried_way, body);
    interpolate_to_particles(accelerations,
                             decomposition.blocks(),
                             parameters.lattice,
                             ParticleProperty::magnetic_acceleration,
                             bodies);
    for (Body<dim> &body : bodies)
      set_rate_of_carried_force(state.carried_way, body);
    state.carried_way      = 0.;
    state.path_since_solve = 0.;
  }

  template class MagneticCoupling<2>;
  template class MagneticCoupling<3>;
} // namespace magmpm
