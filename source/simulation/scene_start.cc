// How a scene begins, and how it goes on from a checkpoint.

#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/simulation/runaway_check.h>
#include <magmpm/simulation/scene.h>

namespace magmpm
{
  template <int dim>
  void
  Scene<dim>::seed_bodies()
  {
    for (unsigned int b = 0; b < all_bodies.size(); ++b)
      {
        const BodyParameters<dim> &body = parameters.bodies[b];
        seed_particles(body,
                       parameters.lattice,
                       b,
                       parallel::rank(communicator),
                       parallel::n_ranks(communicator),
                       all_bodies[b]);
        if (parallel::sum(all_bodies[b].particles.size(), communicator) == 0)
          throw InputError("body '" + body.name +
                           "' holds no particle: it is smaller than the distance between "
                           "particles. Make it larger, or 'Box/Cell size' smaller.");
      }
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
  Scene<dim>::begin()
  {
    seed_bodies();
    set_up_decomposition();
    holder.set_time(0.);
    magnetic.update(state.clock, all_bodies);
    find_sums();
    match_attraction();
    if (!attraction.description().empty())
      state.notices.push_back({false, attraction.description()});

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

  template <int dim>
  void
  Scene<dim>::match_attraction()
  {
    if (!attraction.waits_for_match())
      return;
    Vector<dim> magnetic_force;
    for (const ParticleSums<dim> &sums : state.sums)
      magnetic_force += sums.magnetic_force;
    attraction.match(magnetic_force, all_bodies, communicator);
    magnetic.end(all_bodies);
    find_sums();
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

#define INSTANTIATE(dim)                                                      \
  template void Scene<dim>::begin();                                          \
  template std::vector<SectionTitle> Scene<dim>::titles() const;              \
  template std::vector<Section> Scene<dim>::save();                           \
  template void Scene<dim>::load(                                             \
    const std::vector<Section> &, const std::function<void(std::vector<Body<dim>> &)> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
