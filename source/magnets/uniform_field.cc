#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/uniform_field.h>

namespace magmpm
{
  template <int dim>
  UniformField<dim>::UniformField(const std::string &name,
                                  const UniformFieldParameters<dim> &parameters)
    : MagneticSource<dim>(name)
    , field_in_time(parameters.field)
  {
    set_time(0.);
  }

  template <int dim>
  void
  UniformField<dim>::set_time(const double time)
  {
    const Vector<dim> before = current_field;
    current_field            = field_in_time(time);
    if (norm(current_field - before) != 0.)
      this->note_change();
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
  void
  UniformField<dim>::set_pose(const Pose<dim> & /*pose*/)
  {
    throw RunError("The uniform field '" + this->name() + "' has no place and cannot be moved.");
  }

  template class UniformField<2>;
  template class UniformField<3>;
} // namespace magmpm
