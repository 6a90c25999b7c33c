// What can be seen of a scene from outside: columns of the statistics, magnets, notices.

#include <magmpm/base/exceptions.h>
#include <magmpm/simulation/scene.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  ParticleSums<dim>
  Scene<dim>::total() const
  {
    ParticleSums<dim> total;
    for (const ParticleSums<dim> &sums : state.sums)
      total += sums;
    return total;
  }

  template <int dim>
  void
  Scene<dim>::add_sums(parallel::Reduction &reduction, const double time)
  {
    state.sums.clear();
    state.fewest_particles = 0.;
    for (const Body<dim> &body : all_bodies)
      {
        state.sums.push_back(particle_sums(
          body, parameters.lattice, parameters.gravity(time), parameters.magnetics.model()));
        state.fewest_particles += static_cast<double>(body.particles.size());
      }
    for (ParticleSums<dim> &sums : state.sums)
      sums.for_each_member(reduction);
    reduction.min(state.fewest_particles);
  }

  template <int dim>
  void
  Scene<dim>::find_sums()
  {
    lattice_motion.smooth_volume(decomposition->partition(), all_bodies);
    parallel::Reduction reduction;
    add_sums(reduction, state.clock.time);
    reduction.carry_out(communicator);
  }

  template <int dim>
  ColumnTable
  Scene<dim>::columns() const
  {
    ColumnTable table;
    table.add("step", "", [this] { return state.clock.step; });
    table.add("time", "s", [this] { return state.clock.time; });
    table.add("dt", "s", [this] { return state.clock.time_step; });
    table.add_text("limit of dt", [this] { return state.limit; });
    table.add("particles", "", [this] { return total().n_particles; });
    table.add("lost particles", "", [this] { return state.lost_particles; });
    table.add("migrated particles", "", [this] { return state.migrated_particles; });
    table.add("fewest particles of a rank", "", [this] { return state.fewest_particles; });
    table.add("load imbalance", "-", [this] { return state.imbalance; });
    table.add("mesh changes", "", [this] { return state.mesh_changes; });
    add_particle_columns(table);
    for (const Coupling *coupling : couplings())
      coupling->add_columns(table);
    return table;
  }

  template <int dim>
  void
  Scene<dim>::add_particle_columns(ColumnTable &table) const
  {
    using Unit  = ColumnUnits<dim>;
    using Total = ParticleSums<dim>;

    const auto add = [&](const char *name, const char *unit, double Total::*member) {
      table.add(name, unit, [this, member] { return total().*member; });
    };
    add("kinetic energy", Unit::energy, &Total::kinetic_energy);
    add("elastic energy", Unit::energy, &Total::elastic_energy);
    add("gravitational energy", Unit::energy, &Total::gravitational_energy);
    table.add_vector<dim>("momentum", Unit::momentum, [this] { return total().momentum; });
    table.add_vector<n_axial_components<dim>>("angular momentum", Unit::angular_momentum, [this] {
      return total().angular_momentum;
    });
    table.add_vector<dim>("centre of mass", "m", [this] {
      const Total sum = total();
      return (sum.mass > 0. ? 1. / sum.mass : 0.) * sum.mass_times_position;
    });
    add("max |v|", "m/s", &Total::max_speed);
    table.add("min J", "-", [this] {
      const Total sum = total();
      return std::min(sum.min_volume_ratio, sum.max_volume_ratio);
    });
    add("max J", "-", &Total::max_volume_ratio);
    add("max |H|", "A/m", &Total::max_field);
    add("max |M|", "A/m", &Total::max_magnetization);
    for (std::size_t b = 0; b < all_bodies.size(); ++b)
      {
        table.add_vector<dim>(body_column(all_bodies[b].name, "magnetic force"),
                              Unit::force,
                              [this, b] { return state.sums[b].magnetic_force; });
        table.add_vector<dim>(body_column(all_bodies[b].name, "magnetic moment"),
                              Unit::magnetic_moment,
                              [this, b] { return state.sums[b].magnetic_moment; });
      }
  }

  template <int dim>
  void
  Scene<dim>::prepare_row()
  {
    for (Coupling *coupling : couplings())
      coupling->prepare_row();
  }

  template <int dim>
  void
  Scene<dim>::end_row()
  {
    for (Coupling *coupling : couplings())
      coupling->end_row();
  }

  template <int dim>
  ForceAndTorque<dim>
  Scene<dim>::force_on_magnet(const std::string &name)
  {
    const auto &sources = external_field.sources();
    const auto found    = std::find_if(sources.begin(), sources.end(), [&](const auto &source) {
      return source->name() == name;
    });
    if (found == sources.end())
      throw InputError("the scene has no magnet '" + name + "'.");
    magnetic.prepare_row();
    return holder.forces_on_magnets()[found - sources.begin()];
  }

  template <int dim>
  void
  Scene<dim>::update_potential()
  {
    // The force that particles carry stays: output changes a run by no more than where the next Newton
    // iteration starts, within its tolerance.
    if (magnetic.is_active())
      magnetic.solve_for_output(all_bodies);
  }

  template <int dim>
  void
  Scene<dim>::move_bodies_to_now()
  {
    holder.set_time(state.clock.time);
  }

  template <int dim>
  std::vector<Notice>
  Scene<dim>::take_notices()
  {
    return std::exchange(state.notices, {});
  }

#define INSTANTIATE(dim)                                                         \
  template void Scene<dim>::add_sums(parallel::Reduction &, const double);       \
  template void Scene<dim>::find_sums();                                         \
  template ParticleSums<dim> Scene<dim>::total() const;                          \
  template ColumnTable Scene<dim>::columns() const;                              \
  template void Scene<dim>::prepare_row();                                       \
  template void Scene<dim>::end_row();                                           \
  template ForceAndTorque<dim> Scene<dim>::force_on_magnet(const std::string &); \
  template void Scene<dim>::update_potential();                                  \
  template void Scene<dim>::move_bodies_to_now();                                \
  template std::vector<Notice> Scene<dim>::take_notices();

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
