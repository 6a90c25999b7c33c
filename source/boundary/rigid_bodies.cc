#include <magmpm/boundary/rigid_bodies.h>

#include <algorithm>
#include <utility>

namespace magmpm
{
  template <int dim>
  double
  mass_of(const Shape<dim> &shape, const double mass, const double density)
  {
    return mass > 0. ? mass : density * shape.volume_moments().volume;
  }

  template <int dim>
  RigidBodies<dim>::RigidBodies(const std::vector<SourceParameters<dim>> &source_parameters,
                                const std::vector<RigidBodyParameters<dim>> &parameters,
                                const ExternalField<dim> &sources)
    : sources(sources)
  {
    for (std::size_t s = 0; s < source_parameters.size(); ++s)
      if (source_parameters[s].is_free || sources.sources()[s]->contact() != ContactCondition::none)
        add_source(source_parameters[s], s);
    for (const RigidBodyParameters<dim> &body : parameters)
      add_body(body);
    set_time(0.);
  }

  template <int dim>
  void
  RigidBodies<dim>::add_source(const SourceParameters<dim> &parameters, const std::size_t source)
  {
    const MagneticSource<dim> &magnet = *sources.sources()[source];
    // The source owns its shape.
    const std::shared_ptr<const Shape<dim>> shape(std::shared_ptr<void>(), magnet.shape());
    RigidBody<dim> body(magnet.name(), shape, {magnet.contact(), magnet.friction()});
    body.place(magnet.pose(), {});
    if (parameters.is_free)
      {
        body.set_free(mass_of(*shape, parameters.mass, parameters.density));
        body.set_motion({parameters.velocity, parameters.angular_velocity});
      }
    bodies.push_back(std::move(body));
    origins.push_back({source, {}});
  }

  template <int dim>
  void
  RigidBodies<dim>::add_body(const RigidBodyParameters<dim> &parameters)
  {
    const std::shared_ptr<const Shape<dim>> shape = make_shape(parameters.shape);
    RigidBody<dim> body(parameters.name, shape, parameters.contact);
    Origin origin;
    if (parameters.is_free)
      {
        body.set_free(mass_of(*shape, parameters.mass, parameters.density));
        body.set_motion({parameters.velocity, parameters.angular_velocity});
      }
    else
      origin.script = parameters.pose;
    bodies.push_back(std::move(body));
    origins.push_back(std::move(origin));
  }

  template <int dim>
  void
  RigidBodies<dim>::set_time(const double time)
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        RigidBody<dim> &body = bodies[b];
        if (origins[b].script)
          body.move_to((*origins[b].script)(time), motion_at(*origins[b].script, time));
        else if (origins[b].source)
          {
            MagneticSource<dim> &source = *sources.sources()[*origins[b].source];
            if (body.is_free())
              source.set_pose(body.pose_of_shape(), body.motion_of_shape());
            else
              body.place(source.pose(), source.motion());
          }
      }
  }

  template <int dim>
  bool
  RigidBodies<dim>::any_is_free() const
  {
    return std::any_of(bodies.begin(), bodies.end(), [](const auto &body) {
      return body.is_free();
    });
  }

  template <int dim>
  bool
  RigidBodies<dim>::any_magnet_is_free() const
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (bodies[b].is_free() && origins[b].source)
        return true;
    return false;
  }

  template <int dim>
  std::vector<double>
  RigidBodies<dim>::record() const
  {
    std::vector<double> record;
    for (const RigidBody<dim> &body : bodies)
      if (body.is_free())
        body.append_record(record);
    return record;
  }

  template <int dim>
  void
  RigidBodies<dim>::restore(const std::vector<double> &record)
  {
    std::size_t place = 0;
    for (std::size_t b = 0; b < bodies.size() && !record.empty(); ++b)
      if (bodies[b].is_free())
        {
          bodies[b].read_record(record, place);
          if (origins[b].source)
            sources.sources()[*origins[b].source]->set_pose(bodies[b].pose_of_shape(),
                                                            bodies[b].motion_of_shape());
        }
  }

#define MAGMPM_INSTANTIATE(dim)    \
  template class RigidBodies<dim>; \
  template double mass_of<dim>(const Shape<dim> &, double, double);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
