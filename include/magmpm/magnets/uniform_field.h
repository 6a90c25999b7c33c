#pragma once

#include <magmpm/magnets/magnetic_source.h>
#include <magmpm/motion/time_function.h>

namespace magmpm
{
  /** A field H(t) that is the same everywhere, as between large pole pieces. */
  template <int dim>
  class UniformField : public MagneticSource<dim>
  {
  public:
    /** @throw InputError  if the field cannot be parsed, or a contact condition is given. */
    explicit UniformField(const SourceParameters<dim> &parameters);

    void
    set_time(const double time) override;

    Vector<dim>
    field(const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &point) const override;

    bool
    is_constant() const override;

    /** H [A/m]. */
    Vector<dim>
    strength() const override;

    bool
    has_place() const override
    {
      return false;
    }

    /** The origin: a uniform field has no place. */
    const Pose<dim> &
    pose() const override;

    const RigidMotion<dim> &
    motion() const override;

    /** @throw RunError  always. */
    void
    set_pose(const Pose<dim> &pose, const RigidMotion<dim> &motion) override;

  private:
    TimeFunction<Vector<dim>> field_in_time;
    Vector<dim> current_field; ///< H [A/m]
    const Pose<dim> origin;
    const RigidMotion<dim> rest;
  };
} // namespace magmpm
