#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/motion/pose_function.h>

#include <algorithm>
#include <utility>

namespace magmpm
{
  template <int dim>
  RigidBody<dim>
  make_rigid_body(const std::string &name,
                  const std::shared_ptr<const Shape<dim>> &shape,
                  const RigidBodyProperties<dim> &properties,
                  const Pose<dim> &pose)
  {
    RigidBody<dim> body(name, shape, properties.contact);
    body.place(pose, {});
    if (properties.is_free)
      {
        body.set_free(properties.mass > 0. ? properties.mass
                                           : properties.density * shape->volume_moments().volume);
        body.set_motion({properties.velocity, properties.angular_velocity});
      }
    return body;
  }

  template <int dim>
  std::vector<MovedBody<dim>>
  make_rigid_bodies(const std::vector<RigidBodyParameters<dim>> &parameters)
  {
    std::vector<MovedBody<dim>> result;
    for (const RigidBodyParameters<dim> &body : parameters)
      {
        const std::shared_ptr<const Shape<dim>> shape = make_shape(body.shape);
        result.push_back({make_rigid_body(body.name, shape, body.properties),
                          body.pose,
                          MovedBody<dim>::Frame::body,
                          {}});
      }
    return result;
  }

  template <int dim>
  RigidBodies<dim>::RigidBodies(const std::vector<MovedBody<dim>> &moved)
  {
    for (const MovedBody<dim> &one : moved)
      {
        bodies.push_back(one.body);
        origins.push_back({one.script, one.frame, one.source});
      }
    set_time(0.);
  }

  template <int dim>
  void
  RigidBodies<dim>::set_time(const double time)
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        if (bodies[b].is_free())
          continue;
        const TimeFunction<Pose<dim>> &script = origins[b].script;
        if (origins[b].frame == MovedBody<dim>::Frame::body)
          bodies[b].move_to(script(time), motion_at(script, time));
        else
          bodies[b].place(script(time), motion_at(script, time));
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
    for (RigidBody<dim> &body : bodies)
      if (body.is_free() && !record.empty())
        body.read_record(record, place);
  }

#define MAGMPM_INSTANTIATE(dim)                                                      \
  template class RigidBodies<dim>;                                                   \
  template RigidBody<dim> make_rigid_body(const std::string &,                       \
                                          const std::shared_ptr<const Shape<dim>> &, \
                                          const RigidBodyProperties<dim> &,          \
                                          const Pose<dim> &);                        \
  template std::vector<MovedBody<dim>> make_rigid_bodies(                            \
    const std::vector<RigidBodyParameters<dim>> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
#undef MAGMPM_INSTANTIATE
} // namespace magmpm
