// How the particles of a scene come to their places, at its start and later, and how it goes on from
// a checkpoint.

#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/hydrostatic_columns.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/simulation/scene.h>
#include <magmpm/simulation/seeding_report.h>
#include <magmpm/simulation/surface_report.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Compresses the hydrostatic ones. @throw InputError  on all ranks, if one yields too much. Collective. */
    template <int dim>
    void
    compress_by_weight(const Parameters<dim> &parameters,
                       const std::vector<Obstacle<dim>> &rigid_bodies,
                       const MPI_Comm communicator,
                       std::vector<Body<dim>> &bodies)
    {
      constexpr double modulus_per_weight = 3.; // at which J is at least 0.58
      const auto is_hydrostatic           = [](const BodyParameters<dim> &body) {
        return body.initial_state == InitialState::hydrostatic;
      };
      if (std::none_of(parameters.bodies.begin(), parameters.bodies.end(), is_hydrostatic))
        return;
      const HydrostaticColumns<dim> columns(
        parameters.bodies, bodies, parameters.gravity(0.), parameters.lattice, rigid_bodies);
      for (std::size_t b = 0; b < bodies.size(); ++b)
        if (is_hydrostatic(parameters.bodies[b]))
          {
            const Compression compression = columns.compress(b, bodies[b].particles);
            const double ratio            = parallel::min(compression.smallest_ratio, communicator);
            const double weight           = parallel::max(compression.largest_weight, communicator);
            if (ratio < Compression::least_ratio)
              throw InputError(
                "body '" + bodies[b].name +
                "' with Initial state = hydrostatic is compressed to J = " + to_text(ratio) +
                " by the weight of what stands above, " + to_text(weight) + " Pa; J may be " +
                to_text(Compression::least_ratio) +
                " to 1. Set 'Bulk modulus' of its material to at least " +
                to_text(modulus_per_weight * weight) + " Pa.");
          }
    }
  } // namespace

  template <int dim>
  void
  Scene<dim>::seed_bodies()
  {
    // Particles keep out of rigid bodies and solid magnets, which may touch what they fill.
    std::vector<Obstacle<dim>> obstacles;
    for (const RigidBody<dim> &rigid : holder.bodies().all())
      obstacles.push_back(
        [&rigid](const Vector<dim> &point) { return rigid.surface_distance(point); });

    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        const BodyParameters<dim> &body = parameters.bodies[b];
        seed_particles(body,
                       parameters.lattice,
                       b,
                       parallel::rank(communicator),
                       parallel::n_ranks(communicator),
                       all_bodies[b],
                       obstacles);
        if (parallel::sum(all_bodies[b].particles.size(), communicator) == 0)
          throw InputError("body '" + body.name +
                           "' holds no particle: it is smaller than the distance between "
                           "particles. Make it larger, or 'Box/Cell size' smaller.");
      }
    compress_by_weight(parameters, obstacles, communicator, all_bodies);
    state.notices.push_back({false, seeding_report(parameters.bodies, all_bodies, communicator)});
    if (const std::string surfaces = surface_report(parameters); !surfaces.empty())
      state.notices.push_back({false, surfaces});
  }

  template <int dim>
  void
  Scene<dim>::set_up_decomposition()
  {
    magnetic.reset(); // sees the mesh
    decomposition = std::make_unique<DomainDecomposition<dim>>(parameters, communicator);
    if (parameters.mesh.carries_potential)
      magnetic.set_up(decomposition->mesh(), decomposition->partition());
    // Where particles are when a scene begins or goes on is no migration, and no change of the mesh.
    const std::size_t n_migrated = state.migrated_particles;
    const unsigned int n_changes = state.mesh_changes;
    regroup_particles();
    state.migrated_particles = n_migrated;
    state.mesh_changes       = n_changes;
  }

  template <int dim>
  void
  Scene<dim>::regroup_particles()
  {
    const parallel::PhaseTimer::Scope timed(phase_timer, "Sort and migrate");
    const Regrouping regrouping = decomposition->regroup(all_bodies);
    if (regrouping.n_lost > 0)
      {
        const std::string text = report(regrouping, state.clock.time);
        if (!parameters.walls.removes_leaving_particles)
          throw RunError(text + " Take a larger box, another condition than open for this face, or "
                                "'Particles leaving the box = remove' in the section 'Walls'.");
        state.notices.push_back({true, text});
      }
    state.lost_particles += regrouping.n_lost;
    state.migrated_particles += regrouping.n_migrated;
    if (regrouping.mesh.is_rebalanced)
      state.notices.push_back({false, report(regrouping.mesh, parallel::n_ranks(communicator))});
    state.mesh_changes += regrouping.mesh.is_change();
    state.imbalance = regrouping.mesh.imbalance;
    lattice_motion.reinit(decomposition->blocks().size());
    for (const std::string &weld :
         lattice_motion.weld_check().find_welds(all_bodies, state.clock.time))
      state.notices.push_back({true, weld});
  }

  template <int dim>
  std::vector<SectionTitle>
  Scene<dim>::titles() const
  {
    std::vector<SectionTitle> titles = {{"scene", 1}};
    for (const Coupling *coupling : couplings())
      titles.push_back(coupling->title());
    return titles;
  }

  template <int dim>
  std::vector<Section>
  Scene<dim>::save()
  {
    set_up_decomposition();
    std::vector<Section> sections = {{{"scene", 1}, pack(state)}};
    for (const Coupling *coupling : couplings())
      sections.push_back({coupling->title(), coupling->save()});
    return sections;
  }

  template <int dim>
  void
  Scene<dim>::load(const std::vector<Section> &sections,
                   const std::function<void(std::vector<Body<dim>> &)> &append_particles)
  {
    unpack(section_named("scene", sections), state);
    for (Coupling *coupling : couplings())
      coupling->load(section_named(coupling->title().name, sections));
    append_particles(all_bodies);
    set_up_decomposition();
  }

#define INSTANTIATE(dim)                                         \
  template void Scene<dim>::seed_bodies();                       \
  template void Scene<dim>::set_up_decomposition();              \
  template void Scene<dim>::regroup_particles();                 \
  template std::vector<SectionTitle> Scene<dim>::titles() const; \
  template std::vector<Section> Scene<dim>::save();              \
  template void Scene<dim>::load(const std::vector<Section> &,   \
                                 const std::function<void(std::vector<Body<dim>> &)> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
