#include <magmpm/boundary/rigid_body.h>

#include <algorithm>
#include <utility>

namespace magmpm
{
  template <int dim>
  RigidBody<dim>::RigidBody(std::string name,
                            std::shared_ptr<const Shape<dim>> shape,
                            const SurfaceContact &contact)
    : body_name(std::move(name))
    , body_shape(std::move(shape))
    , surface_contact(contact)
    , centroid(body_shape->volume_moments().centroid)
  {
    const BoundingBox<dim> box = body_shape->bounding_box();
    Vector<dim> farthest;
    for (int d = 0; d < dim; ++d)
      farthest[d] = std::max(centroid[d] - box.lower[d], box.upper[d] - centroid[d]);
    radius                = norm(farthest);
    current_pose.position = centroid;
  }

  template <int dim>
  void
  RigidBody<dim>::set_free(const double mass)
  {
    properties           = mass_properties(body_shape->volume_moments(), mass);
    momentum_of_rotation = inertia() * angular_velocity;
  }

  template <int dim>
  void
  RigidBody<dim>::place(const Pose<dim> &pose_of_shape, const RigidMotion<dim> &motion_of_shape)
  {
    const Vector<dim> position = pose_of_shape.to_world(centroid);
    move_to({position, pose_of_shape.rotation},
            {motion_of_shape.velocity_at(position - pose_of_shape.position),
             motion_of_shape.angular_velocity});
  }

  template <int dim>
  void
  RigidBody<dim>::move_to(const Pose<dim> &pose, const RigidMotion<dim> &motion)
  {
    current_pose     = pose;
    velocity         = motion.velocity;
    angular_velocity = motion.angular_velocity;
  }

  template <int dim>
  void
  RigidBody<dim>::set_motion(const RigidMotion<dim> &motion)
  {
    velocity             = motion.velocity;
    momentum_of_rotation = inertia() * motion.angular_velocity;
  }

  template <int dim>
  void
  RigidBody<dim>::set_pose(const Pose<dim> &pose)
  {
    current_pose = pose;
  }

  template <int dim>
  void
  RigidBody<dim>::add_impulse(const Vector<dim> &impulse, const Axial &angular_impulse)
  {
    velocity += (1. / properties->mass) * impulse;
    momentum_of_rotation += angular_impulse;
  }

  template <int dim>
  void
  RigidBody<dim>::advance(const double time_step)
  {
    current_pose.position += time_step * velocity;
    if constexpr (dim == 2)
      turn(0, time_step);
    else
      {
        turn(0, 0.5 * time_step);
        turn(1, 0.5 * time_step);
        turn(2, time_step);
        turn(1, 0.5 * time_step);
        turn(0, 0.5 * time_step);
      }
    // Rounding adds up over millions of steps: one step of Newton's method towards R^T R = I.
    const Matrix<dim> &rotation = current_pose.rotation;
    current_pose.rotation = 1.5 * rotation + (-0.5) * (rotation * (transpose(rotation) * rotation));
  }

  template <int dim>
  void
  RigidBody<dim>::turn(const int k, const double time_step)
  {
    const double rate = along_axes(momentum_of_rotation)[k] / properties->moments[k];
    Axial angle; // in the world
    if constexpr (dim == 2)
      angle[0] = time_step * rate;
    else
      {
        Vector<dim> axis;
        for (int d = 0; d < dim; ++d)
          axis[d] = properties->axes(d, k);
        angle = (time_step * rate) * (current_pose.rotation * axis);
      }
    current_pose.rotation = rotation_by<dim>(angle) * current_pose.rotation;
  }

  template <int dim>
  typename RigidBody<dim>::Axial
  RigidBody<dim>::along_axes(const Axial &axial) const
  {
    if constexpr (dim == 2)
      return axial;
    else
      return transpose(current_pose.rotation * properties->axes) * axial;
  }

  template <int dim>
  Pose<dim>
  RigidBody<dim>::pose_of_shape() const
  {
    return {current_pose.to_world((-1.) * centroid), current_pose.rotation};
  }

  template <int dim>
  RigidMotion<dim>
  RigidBody<dim>::motion() const
  {
    if (!is_free())
      return {velocity, angular_velocity};
    Axial rate = along_axes(momentum_of_rotation);
    for (int k = 0; k < n_axial_components<dim>; ++k)
      rate[k] /= properties->moments[k];
    if constexpr (dim == 2)
      return {velocity, rate};
    else
      return {velocity, current_pose.rotation * (properties->axes * rate)};
  }

  template <int dim>
  RigidMotion<dim>
  RigidBody<dim>::motion_of_shape() const
  {
    const RigidMotion<dim> now = motion();
    return {now.velocity_at(pose_of_shape().position - current_pose.position),
            now.angular_velocity};
  }

  template <int dim>
  double
  RigidBody<dim>::max_speed() const
  {
    const RigidMotion<dim> now = motion();
    return norm(now.velocity) + radius * norm(now.angular_velocity);
  }

  template <int dim>
  SurfaceDistance<dim>
  RigidBody<dim>::surface_distance(const Vector<dim> &point) const
  {
    SurfaceDistance<dim> nearest =
      body_shape->surface_distance(centroid + current_pose.to_own(point));
    nearest.normal = current_pose.rotation * nearest.normal;
    return nearest;
  }

  template <int dim>
  std::vector<Vector<dim>>
  RigidBody<dim>::surface_points(const double spacing) const
  {
    std::vector<Vector<dim>> points = body_shape->surface_points(spacing);
    for (Vector<dim> &point : points)
      point -= centroid;
    return points;
  }

  template <int dim>
  Matrix<n_axial_components<dim>>
  RigidBody<dim>::inertia() const
  {
    Matrix<n_axial_components<dim>> moments;
    for (int k = 0; k < n_axial_components<dim>; ++k)
      moments(k, k) = properties->moments[k];
    if constexpr (dim == 2)
      return moments;
    else
      {
        const Matrix<dim> axes = current_pose.rotation * properties->axes;
        return axes * (moments * transpose(axes));
      }
  }

  template <int dim>
  double
  RigidBody<dim>::kinetic_energy() const
  {
    return 0.5 * (properties->mass * norm_square(velocity) +
                  dot(momentum_of_rotation, motion().angular_velocity));
  }

  namespace
  {
    /** Calls action(number) for all numbers that a record holds. */
    template <int dim, typename PoseOfBody, typename Linear, typename Angular, typename Action>
    void
    for_state(PoseOfBody &pose, Linear &velocity, Angular &momentum, const Action &action)
    {
      for (int d = 0; d < dim; ++d)
        {
          action(pose.position[d]);
          action(velocity[d]);
          for (int e = 0; e < dim; ++e)
            action(pose.rotation(d, e));
        }
      for (int k = 0; k < n_axial_components<dim>; ++k)
        action(momentum[k]);
    }
  } // namespace

  template <int dim>
  void
  RigidBody<dim>::append_record(std::vector<double> &record) const
  {
    for_state<dim>(current_pose, velocity, momentum_of_rotation, [&](const double number) {
      record.push_back(number);
    });
  }

  template <int dim>
  void
  RigidBody<dim>::read_record(const std::vector<double> &record, std::size_t &place)
  {
    for_state<dim>(current_pose, velocity, momentum_of_rotation, [&](auto &&number) {
      number = record.at(place++);
    });
  }

  template class RigidBody<2>;
  template class RigidBody<3>;
} // namespace magmpm
