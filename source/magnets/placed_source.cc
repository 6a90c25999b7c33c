#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/placed_source.h>

#include <cmath>
#include <utility>

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
  } // namespace

  template <int dim>
  PlacedSource<dim>::PlacedSource(const SourceParameters<dim> &parameters,
                                  SourceParts<dim> parts_of_kind)
    : MagneticSource<dim>(parameters.name)
    , parts(std::move(parts_of_kind))
    , alignment(rotation_to_axis(parts.axis))
    , pose_in_time(parameters.pose)
    , strength_in_time(parameters.strength)
    , solid(parameters.is_solid)
    , refusing(interior_of<dim>(parameters.kind) == Interior::refuses)
  {
    set_time(0.);
  }

  template <int dim>
  void
  PlacedSource<dim>::set_time(const double time)
  {
    const Vector<dim> before = current_amplitude;
    current_amplitude        = strength_in_time(time) * parts.amplitude(time);
    field_amplitude          = parts.is_current ? current_amplitude
                                                : transpose(alignment) * current_amplitude;
    if (norm(current_amplitude - before) != 0.)
      this->note_change();
    if (!is_moved_from_outside)
      move_to(pose_in_time(time));
  }

  template <int dim>
  void
  PlacedSource<dim>::set_pose(const Pose<dim> &pose)
  {
    is_moved_from_outside = true;
    move_to(pose);
  }

  template <int dim>
  void
  PlacedSource<dim>::move_to(const Pose<dim> &pose)
  {
    if (norm(pose.position - current_pose.position) != 0. ||
        frobenius_norm(pose.rotation + (-1.) * current_pose.rotation) != 0.)
      this->note_change();
    current_pose   = pose;
    field_rotation = current_pose.rotation * alignment;
  }

  template <int dim>
  Vector<dim>
  PlacedSource<dim>::field(const Vector<dim> &point) const
  {
    return field_rotation *
           parts.field->field(field_amplitude,
                              transpose(field_rotation) * (point - current_pose.position));
  }

  template <int dim>
  Matrix<dim>
  PlacedSource<dim>::field_gradient(const Vector<dim> &point) const
  {
    return field_rotation *
           (parts.field->field_gradient(
              field_amplitude, transpose(field_rotation) * (point - current_pose.position)) *
            transpose(field_rotation));
  }

  template <int dim>
  Vector<dim>
  PlacedSource<dim>::magnetization(const Vector<dim> &point) const
  {
    if (parts.field->is_inside(transpose(field_rotation) * (point - current_pose.position)))
      return current_pose.rotation * current_amplitude;
    return {};
  }

  template <int dim>
  bool
  PlacedSource<dim>::is_constant() const
  {
    // What has no strength (a mere obstacle) may go where it wants.
    return parts.amplitude.is_constant() && strength_in_time.is_constant() &&
           ((pose_in_time.is_constant() && !is_moved_from_outside) ||
            norm(current_amplitude) == 0.);
  }

  template <int dim>
  Vector<dim>
  PlacedSource<dim>::strength() const
  {
    return field_rotation * parts.field->strength(field_amplitude);
  }

  template <int dim>
  bool
  PlacedSource<dim>::is_axisymmetric() const
  {
    return parts.field->is_axisymmetric(field_amplitude);
  }

  template <int dim>
  double
  PlacedSource<dim>::reach() const
  {
    return parts.field->reach();
  }

  template <int dim>
  const Pose<dim> &
  PlacedSource<dim>::pose() const
  {
    return current_pose;
  }

  template <int dim>
  const Shape<dim> *
  PlacedSource<dim>::shape() const
  {
    return parts.shape.get();
  }

  template <int dim>
  bool
  PlacedSource<dim>::is_solid() const
  {
    return solid;
  }

  template <int dim>
  bool
  PlacedSource<dim>::refuses_material() const
  {
    return refusing;
  }

  template <int dim>
  std::optional<ForceAndTorque<dim>>
  PlacedSource<dim>::force_and_torque(const ActingField<dim> &acting) const
  {
    const Matrix<dim> to_field = transpose(field_rotation);
    auto result = parts.field->force_and_torque(field_amplitude, [&](const Vector<dim> &point) {
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
