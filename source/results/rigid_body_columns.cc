#include <magmpm/results/rigid_body_columns.h>
#include <magmpm/results/statistics_columns.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** Whether there is a surface that particles can be inside of. */
    template <int dim>
    bool
    any_surface(const Parameters<dim> &parameters)
    {
      return !parameters.rigid_bodies.empty() ||
             std::any_of(parameters.sources.begin(), parameters.sources.end(), [](const auto &s) {
               return s.contact != ContactCondition::none;
             });
    }

    template <int dim>
    void
    add_pose(const std::string &body, std::vector<StatisticsColumn> &columns)
    {
      constexpr int n_axial = n_axial_components<dim>;
      add_vector(columns, body_column(body, "position"), dim, "m");
      add_vector(columns, body_column(body, "rotation"), n_axial, "rad");
      add_vector(columns, body_column(body, "velocity"), dim, "m/s");
      add_vector(columns, body_column(body, "angular velocity"), n_axial, "rad/s");
    }

    /** Whether the columns tell where it is. */
    template <int dim>
    bool
    has_pose(const RigidBodies<dim> &bodies, const std::size_t body)
    {
      return bodies.all()[body].is_free() || !bodies.source_of(body);
    }
  } // namespace

  template <int dim>
  std::vector<StatisticsColumn>
  rigid_body_columns(const Parameters<dim> &parameters)
  {
    std::vector<StatisticsColumn> columns;
    for (const SourceParameters<dim> &source : parameters.sources)
      if (source.type != SourceType::uniform_field)
        {
          add_vector(columns, body_column(source.name, "force"), dim, dim == 3 ? "N" : "N/m");
          add_vector(columns,
                     body_column(source.name, "torque"),
                     n_axial_components<dim>,
                     dim == 3 ? "N m" : "N");
        }
    for (const SourceParameters<dim> &source : parameters.sources)
      if (source.is_free)
        add_pose<dim>(source.name, columns);
    for (const RigidBodyParameters<dim> &body : parameters.rigid_bodies)
      add_pose<dim>(body.name, columns);
    if (any_surface(parameters))
      columns.insert(columns.end(),
                     {{"particles inside rigid bodies", ""},
                      {"particles pushed out", ""},
                      {"deepest penetration", "m"}});
    return columns;
  }

  template <int dim>
  void
  set_rigid_body_columns(const Parameters<dim> &parameters,
                         const RigidBodies<dim> &bodies,
                         const std::vector<ForceAndTorque<dim>> &forces,
                         const RunState &state,
                         StatisticsFile &statistics)
  {
    for (std::size_t s = 0; s < parameters.sources.size(); ++s)
      if (parameters.sources[s].type != SourceType::uniform_field)
        {
          const std::string &name = parameters.sources[s].name;
          statistics.set(body_column(name, "force"), forces[s].force);
          statistics.set(body_column(name, "torque"), forces[s].torque);
        }
    for (std::size_t b = 0; b < bodies.all().size(); ++b)
      if (has_pose(bodies, b))
        {
          const RigidBody<dim> &body    = bodies.all()[b];
          const RigidMotion<dim> motion = body.motion();
          statistics.set(body_column(body.name(), "position"), body.pose().position);
          statistics.set(body_column(body.name(), "rotation"),
                         rotation_vector<dim>(body.pose().rotation));
          statistics.set(body_column(body.name(), "velocity"), motion.velocity);
          statistics.set(body_column(body.name(), "angular velocity"), motion.angular_velocity);
        }
    if (any_surface(parameters))
      {
        statistics.set("particles inside rigid bodies",
                       static_cast<double>(state.particles_inside));
        statistics.set("particles pushed out", static_cast<double>(state.particles_pushed_out));
        statistics.set("deepest penetration", state.deepest_penetration);
      }
  }

#define INSTANTIATE(dim)                                                              \
  template std::vector<StatisticsColumn> rigid_body_columns(const Parameters<dim> &); \
  template void set_rigid_body_columns(const Parameters<dim> &,                       \
                                       const RigidBodies<dim> &,                      \
                                       const std::vector<ForceAndTorque<dim>> &,      \
                                       const RunState &,                              \
                                       StatisticsFile &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
