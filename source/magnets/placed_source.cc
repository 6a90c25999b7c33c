#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/placed_source.h>
#include <magmpm/motion/expression.h>
#include <magmpm/motion/pose_function.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
    /** A rotation that turns the axis z into the direction of @p axis; none if that is zero. */
    template <int dim>
    Matrix<dim>
    rotation_to_axis(const Vector<dim> &axis)
    {
      if constexpr (dim == 3)
        if (norm(axis) > 0.)
          {
            const Vector<3> direction = (1. / norm(axis)) * axis;
            const Vector<3> z         = {{0., 0., 1.}};
            const Vector<3> normal    = cross(z, direction);
            const double sine         = norm(normal);
            if (sine == 0.)
              return rotation_by<3>(direction[2] > 0. ? Vector<3>()
                                                      : Vector<3>{{constants::pi, 0., 0.}});
            return rotation_by<3>((std::atan2(sine, direction[2]) / sine) * normal);
          }
      return identity<dim>();
    }

    bool
    has_current(const SourceType type)
    {
      return type == SourceType::current_loop || type == SourceType::straight_wire;
    }

    /** Magnetization [A/m], moment [A m^2], or current [A] (first component), in time. */
    template <int dim>
    TimeFunction<Vector<dim>>
    amplitude_of(const SourceParameters<dim> &parameters)
    {
      const std::string of = " of source '" + parameters.name + "'";
      if (has_current(parameters.type))
        return read_scalar_expression(parameters.current, "Current" + of)
          .transformed([](const double current) {
            Vector<dim> result;
            result[0] = current;
            return result;
          });
      if (parameters.type == SourceType::point_dipole)
        return read_expression<dim>(parameters.moment, "Moment" + of);
      if (parameters.remanence.empty())
        return read_expression<dim>(parameters.magnetization, "Magnetization" + of);
      return read_expression<dim>(parameters.remanence, "Remanence" + of)
        .transformed([](const Vector<dim> &remanence) {
          return (1. / constants::vacuum_permeability) * remanence;
        });
    }

    /** Pose and strength, however they are given. */
    template <int dim>
    KeyFrames<dim>
    motion_of(const SourceParameters<dim> &parameters)
    {
      const std::string of = " of source '" + parameters.name + "'";
      if (!parameters.key_frames.empty())
        return read_key_frames<dim>(
          parameters.key_frames, parameters.interpolation, "Key frames" + of);
      KeyFrames<dim> result;
      TimeFunction<Vector<n_axial_components<dim>>> rotation;
      if (!parameters.rotation.empty())
        rotation = read_expression<n_axial_components<dim>>(parameters.rotation, "Rotation" + of);
      result.pose     = pose_function(read_expression<dim>(parameters.position, "Position" + of),
                                  rotation);
      result.strength = parameters.strength.empty()
                          ? TimeFunction<double>(1.)
                          : read_scalar_expression(parameters.strength, "Strength" + of);
      return result;
    }
  } // namespace

  template <int dim>
  PlacedSource<dim>::PlacedSource(const SourceParameters<dim> &parameters,
                                  std::unique_ptr<SourceField<dim>> field,
                                  std::unique_ptr<Shape<dim>> shape)
    : MagneticSource<dim>(parameters.name)
    , type(parameters.type)
    , own_field(std::move(field))
    , own_shape(std::move(shape))
    , amplitude_in_time(amplitude_of(parameters))
    , alignment(rotation_to_axis(parameters.axis))
    , contact_condition(parameters.contact)
    , friction_coefficient(parameters.friction)
  {
    const KeyFrames<dim> motion = motion_of(parameters);
    pose_in_time                = motion.pose;
    strength_in_time            = motion.strength;
    set_time(0.);
  }

  template <int dim>
  void
  PlacedSource<dim>::set_time(const double time)
  {
    current_amplitude = strength_in_time(time) * amplitude_in_time(time);
    field_amplitude   = has_current(type) ? current_amplitude
                                          : transpose(alignment) * current_amplitude;
    if (!is_moved_from_outside)
      {
        current_pose   = pose_in_time(time);
        current_motion = motion_at(pose_in_time, time);
        field_rotation = current_pose.rotation * alignment;
      }
  }

  template <int dim>
  void
  PlacedSource<dim>::set_pose(const Pose<dim> &pose, const RigidMotion<dim> &motion)
  {
    is_moved_from_outside = true;
    current_pose          = pose;
    current_motion        = motion;
    field_rotation        = current_pose.rotation * alignment;
  }

  template <int dim>
  Vector<dim>
  PlacedSource<dim>::field(const Vector<dim> &point) const
  {
    return field_rotation *
           own_field->field(field_amplitude,
                            transpose(field_rotation) * (point - current_pose.position));
  }

  template <int dim>
  Matrix<dim>
  PlacedSource<dim>::field_gradient(const Vector<dim> &point) const
  {
    return field_rotation *
           (own_field->field_gradient(field_amplitude,
                                      transpose(field_rotation) * (point - current_pose.position)) *
            transpose(field_rotation));
  }

  template <int dim>
  Vector<dim>
  PlacedSource<dim>::magnetization(const Vector<dim> &point) const
  {
    if (own_field->is_inside(transpose(field_rotation) * (point - current_pose.position)))
      return current_pose.rotation * current_amplitude;
    return {};
  }

  template <int dim>
  bool
  PlacedSource<dim>::is_constant() const
  {
    // What has no strength (a mere obstacle) may go where it wants.
    return amplitude_in_time.is_constant() && strength_in_time.is_constant() &&
           ((pose_in_time.is_constant() && !is_moved_from_outside) ||
            norm(current_amplitude) == 0.);
  }

  template <int dim>
  Vector<dim>
  PlacedSource<dim>::strength() const
  {
    return field_rotation * own_field->strength(field_amplitude);
  }

  template <int dim>
  bool
  PlacedSource<dim>::is_axisymmetric() const
  {
    return own_field->is_axisymmetric(field_amplitude);
  }

  template <int dim>
  double
  PlacedSource<dim>::reach() const
  {
    return own_field->reach();
  }

  template <int dim>
  const Pose<dim> &
  PlacedSource<dim>::pose() const
  {
    return current_pose;
  }

  template <int dim>
  const RigidMotion<dim> &
  PlacedSource<dim>::motion() const
  {
    return current_motion;
  }

  template <int dim>
  const Shape<dim> *
  PlacedSource<dim>::shape() const
  {
    return own_shape.get();
  }

  template <int dim>
  ContactCondition
  PlacedSource<dim>::contact() const
  {
    return contact_condition;
  }

  template <int dim>
  double
  PlacedSource<dim>::friction() const
  {
    return friction_coefficient;
  }

  template <int dim>
  bool
  PlacedSource<dim>::refuses_material() const
  {
    return type == SourceType::point_dipole;
  }

  template <int dim>
  std::optional<ForceAndTorque<dim>>
  PlacedSource<dim>::force_and_torque(const ActingField<dim> &acting) const
  {
    const Matrix<dim> to_field = transpose(field_rotation);
    auto result = own_field->force_and_torque(field_amplitude, [&](const Vector<dim> &point) {
      const LocalField<dim> local = acting(current_pose.position + field_rotation * point);
      return LocalField<dim>{to_field * local.field, to_field * (local.gradient * field_rotation)};
    });
    if (result)
      {
        result->force = field_rotation * result->force;
        if constexpr (dim == 3)
          result->torque = field_rotation * result->torque;
      }
    return result;
  }

  template class PlacedSource<2>;
  template class PlacedSource<3>;
} // namespace magmpm
