// What the coupling of rigid bodies tells of itself: limits of the time step, columns, checkpoint.

#include <magmpm/coupling/magnet_bodies.h>
#include <magmpm/coupling/rigid_body_coupling.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace magmpm
{
  namespace
  {
    template <int n>
    double
    smallest_diagonal(const Matrix<n> &matrix)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (int i = 0; i < n; ++i)
        smallest = std::min(smallest, matrix(i, i));
      return smallest;
    }
  } // namespace

  template <int dim>
  void
  RigidBodyCoupling<dim>::limit_step(StepConditions &conditions) const
  {
    for (const RigidBody<dim> &body : rigid_bodies.all())
      conditions.collider_speed = std::max(conditions.collider_speed, body.max_speed());
    conditions.rotation_rate = 0.;
    const double gravity     = conditions.rigid_acceleration;
    if (!rigid_bodies.any_is_free())
      return;
    const std::vector<ForceAndTorque<dim>> forces = forces_on_free_magnets();
    for (std::size_t b = 0; b < rigid_bodies.all().size(); ++b)
      {
        const RigidBody<dim> &body = rigid_bodies.all()[b];
        if (!body.is_free())
          continue;
        const ForceAndTorque<dim> magnetic = magnetic_force(b, forces);
        const double inertia               = smallest_diagonal(body.inertia());
        conditions.rigid_acceleration =
          std::max(conditions.rigid_acceleration,
                   gravity + norm(magnetic.force) / body.mass() +
                     body.bounding_radius() * norm(magnetic.torque) / inertia);
        conditions.rotation_rate = std::max(
          {conditions.rotation_rate,
           norm(body.motion().angular_velocity),
           std::sqrt(norm(magnetic.torque) / inertia),
           rigid_bodies.source_of(b) ? magnet_forces.swing_rate(*rigid_bodies.source_of(b), inertia)
                                     : 0.});
      }
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::prepare_row()
  {
    forces_of_row = magnet_forces.total(reactions);
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::end_row()
  {
    counts.deepest = 0.;
    counts.depth   = 0.;
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::add_pose(const RigidBody<dim> &body, ColumnTable &table) const
  {
    constexpr int n_axial = n_axial_components<dim>;
    table.add_vector<dim>(body_column(body.name(), "position"), "m", [&body] {
      return body.pose().position;
    });
    table.add_vector<n_axial>(body_column(body.name(), "rotation"), "rad", [&body] {
      return rotation_vector<dim>(body.pose().rotation);
    });
    table.add_vector<dim>(body_column(body.name(), "velocity"), "m/s", [&body] {
      return body.motion().velocity;
    });
    table.add_vector<n_axial>(body_column(body.name(), "angular velocity"), "rad/s", [&body] {
      return body.motion().angular_velocity;
    });
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::add_columns(ColumnTable &table) const
  {
    table.add("held particles", "", [this] { return counts.held; });
    if (solid_contacts.size() > 1 || solid_contacts.front().has_surfaces())
      {
        table.add("contact energy", ColumnUnits<dim>::energy, [this] { return counts.energy; });
        table.add("deepest contact", "m", [this] { return counts.depth; });
      }
    const auto &sources = external_field.sources();
    for (std::size_t s = 0; s < sources.size(); ++s)
      if (sources[s]->has_place())
        {
          table.add_vector<dim>(body_column(sources[s]->name(), "force"),
                                ColumnUnits<dim>::force,
                                [this, s] { return forces_of_row[s].force; });
          table.add_vector<n_axial_components<dim>>(body_column(sources[s]->name(), "torque"),
                                                    ColumnUnits<dim>::torque,
                                                    [this, s] { return forces_of_row[s].torque; });
        }
    bool any_surface = false;
    for (std::size_t b = 0; b < rigid_bodies.all().size(); ++b)
      {
        const RigidBody<dim> &body = rigid_bodies.all()[b];
        any_surface = any_surface || body.contact().condition != ContactCondition::none;
        // A scripted magnet is where its script says.
        if (body.is_free() || !rigid_bodies.source_of(b))
          add_pose(body, table);
      }
    if (any_surface)
      {
        table.add("particles inside rigid bodies", "", [this] { return counts.inside; });
        table.add("particles pushed out", "", [this] { return counts.pushed; });
        table.add("deepest penetration", "m", [this] { return counts.deepest; });
      }
  }

  template <int dim>
  SectionTitle
  RigidBodyCoupling<dim>::title() const
  {
    return {"rigid bodies", 2};
  }

  template <int dim>
  std::string
  RigidBodyCoupling<dim>::save() const
  {
    return pack(std::make_pair(counts, rigid_bodies.record()));
  }

  template <int dim>
  void
  RigidBodyCoupling<dim>::load(const std::string &bytes)
  {
    std::pair<HoldCounts, std::vector<double>> record;
    unpack(bytes, record);
    counts = record.first;
    rigid_bodies.restore(record.second);
    move_free_sources(rigid_bodies, external_field);
  }

#define INSTANTIATE(dim)                                                    \
  template void RigidBodyCoupling<dim>::limit_step(StepConditions &) const; \
  template void RigidBodyCoupling<dim>::prepare_row();                      \
  template void RigidBodyCoupling<dim>::end_row();                          \
  template void RigidBodyCoupling<dim>::add_columns(ColumnTable &) const;   \
  template SectionTitle RigidBodyCoupling<dim>::title() const;              \
  template std::string RigidBodyCoupling<dim>::save() const;                \
  template void RigidBodyCoupling<dim>::load(const std::string &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
