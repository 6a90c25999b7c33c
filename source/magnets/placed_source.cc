#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/placed_source.h>

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
  } // namespace

  template <int dim>
  PlacedSource<dim>::PlacedSource(const SourceParameters<dim> &parameters,
                                  std::unique_ptr<SourceField<dim>> field,
                                  std::unique_ptr<Shape<dim>> shape)
    : MagneticSource<dim>(parameters.name)
    , type(parameters.type)
    , own_field(std::move(field))
    , own_shape(std::move(shape))
    , source_motion(parameters)
    , script(amplitude_script(parameters))
    , alignment(rotation_to_axis(parameters.axis))
    , contact_condition(parameters.contact)
    , friction_coefficient(parameters.friction)
  {
    set_time(0.);
  }

  template <int dim>
  typename PlacedSource<dim>::AmplitudeScript
  PlacedSource<dim>::amplitude_script(const SourceParameters<dim> &parameters)
  {
    const std::string of = " of source '" + parameters.name + "'";
    AmplitudeScript script;
    if (has_current(parameters.type))
      script.current.emplace(parameters.current, "Current" + of);
    else if (parameters.type == SourceType::point_dipole)
      script.vector.emplace(parameters.moment, "Moment" + of);
    else if (parameters.remanence.empty())
      script.vector.emplace(parameters.magnetization, "Magnetization" + of);
    else
      {
        script.vector.emplace(parameters.remanence, "Remanence" + of);
        script.unit_factor = 1. / constants::vacuum_permeability;
      }
    return script;
  }

  template <int dim>
  bool
  PlacedSource<dim>::AmplitudeScript::is_constant() const
  {
    return vector ? vector->is_constant() : current->is_constant();
  }

  template <int dim>
  Vector<dim>
  PlacedSource<dim>::AmplitudeScript::value(const double time) const
  {
    if (vector)
      return unit_factor * vector->value(time);
    Vector<dim> result;
    result[0] = current->value(time)[0];
    return result;
  }

  template <int dim>
  void
  PlacedSource<dim>::set_time(const double time)
  {
    current_amplitude = source_motion.strength(time) * script.value(time);
    field_amplitude = script.vector ? transpose(alignment) * current_amplitude : current_amplitude;
    if (!is_moved_from_outside)
      {
        current_pose   = source_motion.pose(time);
        current_motion = source_motion.motion(time);
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
    return script.is_constant() && source_motion.strength_is_constant() &&
           ((source_motion.pose_is_constant() && !is_moved_from_outside) ||
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
