#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/uniform_field.h>
#include <magmpm/motion/expression.h>

namespace magmpm
{
  template <int dim>
  UniformField<dim>::UniformField(const SourceParameters<dim> &parameters)
    : MagneticSource<dim>(parameters.name)
    , field_in_time(
        read_expression<dim>(parameters.field, "Field of source '" + parameters.name + "'"))
  {
    if (parameters.contact != ContactCondition::none)
      throw InputError("Source '" + parameters.name +
                       "' is a uniform field, which has no surface, but has a contact condition. "
                       "Set it to none.");
    set_time(0.);
  }

  template <int dim>
  void
  UniformField<dim>::set_time(const double time)
  {
    current_field = field_in_time(time);
  }

  template <int dim>
  Vector<dim>
  UniformField<dim>::field(const Vector<dim> & /*point*/) const
  {
    return current_field;
  }

  template <int dim>
  Matrix<dim>
  UniformField<dim>::field_gradient(const Vector<dim> & /*point*/) const
  {
    return {};
  }

  template <int dim>
  bool
  UniformField<dim>::is_constant() const
  {
    return field_in_time.is_constant();
  }

  template <int dim>
  Vector<dim>
  UniformField<dim>::strength() const
  {
    return current_field;
  }

  template <int dim>
  const Pose<dim> &
  UniformField<dim>::pose() const
  {
    return origin;
  }

  template <int dim>
  const RigidMotion<dim> &
  UniformField<dim>::motion() const
  {
    return rest;
  }

  template <int dim>
  void
  UniformField<dim>::set_pose(const Pose<dim> & /*pose*/, const RigidMotion<dim> & /*motion*/)
  {
    throw RunError("The uniform field '" + this->name() + "' has no place and cannot be moved.");
  }

  template class UniformField<2>;
  template class UniformField<3>;
} // namespace magmpm
