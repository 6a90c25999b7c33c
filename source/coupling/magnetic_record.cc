// What the magnetic coupling tells of itself: limits of the time step, columns, checkpoint.

#include <magmpm/coupling/magnetic_coupling.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/particle_sums.h>

#include <algorithm>

namespace magmpm
{
  template <typename Archive, int dim>
  void
  serialize(Archive &archive, SourceSnapshot<dim> &snapshot, const unsigned int /*version*/)
  {
    archive &snapshot.strength;
    archive &snapshot.pose.position;
    archive &snapshot.pose.rotation;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::find_limits(const std::vector<Body<dim>> &bodies)
  {
    memory.max_wave_speed   = 0.;
    memory.max_acceleration = 0.;
    for (const Body<dim> &body : bodies)
      {
        const ParticleSums<dim> sums =
          particle_sums(body, parameters.lattice, {}, parameters.magnetics.model());
        memory.max_wave_speed   = std::max(memory.max_wave_speed, sums.max_magnetic_wave_speed);
        memory.max_acceleration = std::max(memory.max_acceleration, sums.max_magnetic_acceleration);
      }
    parallel::Reduction reduction;
    reduction.max(memory.max_wave_speed);
    reduction.max(memory.max_acceleration);
    reduction.carry_out(communicator);
  }

  template <int dim>
  void
  MagneticCoupling<dim>::limit_step(StepConditions &conditions) const
  {
    conditions.magnetic_wave_speed = memory.max_wave_speed;
    conditions.acceleration += memory.max_acceleration;
  }

  template <int dim>
  void
  MagneticCoupling<dim>::add_columns(ColumnTable &table) const
  {
    const auto solved = [this](const auto value) {
      return
        [this, value]() -> double { return memory.solved_this_step ? value(memory.report) : 0; };
    };
    table.add("magnetic energy", ColumnUnits<dim>::energy, [this] {
      return memory.report.energy - work;
    });
    table.add("magnetic solves", "", [this] { return memory.n_solves; });
    table.add("way since magnetic solve", "dx", [this] {
      return memory.age.carried_way / parameters.lattice.spacing;
    });
    table.add("Newton steps", "", solved([](const auto &report) { return report.newton.steps; }));
    table.add("line search steps", "", solved([](const auto &report) {
                return report.newton.line_search_steps;
              }));
    table.add("CG iterations", "", solved([](const auto &report) {
                return report.newton.linear_iterations;
              }));
    table.add("Newton residual", "-", solved([](const auto &report) {
                return report.relative_final_residual();
              }));
    table.add("dropped magnetic force", ColumnUnits<dim>::force, [this] {
      return norm(memory.dropped_force);
    });
    table.add("clipped fractions", "", [this] { return memory.report.clipped_fractions; });
    table.add("clipped corrections", "", [this] { return memory.report.clipped_corrections; });
    table.add("potential unknowns", "", [this] { return memory.report.n_unknowns; });
  }

  template <int dim>
  SectionTitle
  MagneticCoupling<dim>::title() const
  {
    return {"magnetics", 2};
  }

  template <int dim>
  std::string
  MagneticCoupling<dim>::save() const
  {
    return pack(std::make_pair(memory, external_field.remembered()));
  }

  template <int dim>
  void
  MagneticCoupling<dim>::load(const std::string &bytes)
  {
    std::pair<MagneticState<dim>, std::vector<SourceSnapshot<dim>>> record;
    unpack(bytes, record);
    memory = record.first;
    external_field.remember(record.second);
  }

#define INSTANTIATE(dim)                                                            \
  template void MagneticCoupling<dim>::find_limits(const std::vector<Body<dim>> &); \
  template void MagneticCoupling<dim>::limit_step(StepConditions &) const;          \
  template void MagneticCoupling<dim>::add_columns(ColumnTable &) const;            \
  template SectionTitle MagneticCoupling<dim>::title() const;                       \
  template std::string MagneticCoupling<dim>::save() const;                         \
  template void MagneticCoupling<dim>::load(const std::string &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
