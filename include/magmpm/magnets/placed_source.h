#pragma once

#include <magmpm/magnets/magnetic_source.h>
#include <magmpm/motion/time_function.h>

#include <memory>

namespace magmpm
{
  /** A source that has a place: a field in its own frame (SourceField), and where that frame is. */
  template <int dim>
  class PlacedSource : public MagneticSource<dim>
  {
  public:
    /**
     * @param field   of this kind of source.
     * @param shape   the space that it fills, in its frame; null: none.
     * @throw InputError  if an expression cannot be parsed, magnetization or current are given in no way
     *                    or in several; names the source.
     */
    PlacedSource(const SourceParameters<dim> &parameters,
                 std::unique_ptr<SourceField<dim>> field,
                 std::unique_ptr<Shape<dim>> shape);

    void
    set_time(const double time) override;

    Vector<dim>
    field(const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &point) const override;

    Vector<dim>
    magnetization(const Vector<dim> &point) const override;

    bool
    is_constant() const override;

    Vector<dim>
    strength() const override;

    bool
    is_axisymmetric() const override;

    double
    reach() const override;

    const Pose<dim> &
    pose() const override;

    const RigidMotion<dim> &
    motion() const override;

    void
    set_pose(const Pose<dim> &pose, const RigidMotion<dim> &motion) override;

    const Shape<dim> *
    shape() const override;

    ContactCondition
    contact() const override;

    double
    friction() const override;

    bool
    refuses_material() const override;

    std::optional<ForceAndTorque<dim>>
    force_and_torque(const ActingField<dim> &acting) const override;

    /** Magnetization [A/m], moment [A m^2], or current [A] (first component), in its own frame. */
    const Vector<dim> &
    amplitude() const
    {
      return current_amplitude;
    }

  private:
    const SourceType type;
    std::unique_ptr<SourceField<dim>> own_field;
    std::unique_ptr<Shape<dim>> own_shape;
    TimeFunction<Pose<dim>> pose_in_time;
    TimeFunction<double> strength_in_time;
    TimeFunction<Vector<dim>> amplitude_in_time;
    Matrix<dim> alignment; ///< turns the frame of own_field, whose axis is z, into the source's
    const ContactCondition contact_condition;
    const double friction_coefficient;
    bool is_moved_from_outside = false;

    Pose<dim> current_pose;
    RigidMotion<dim> current_motion;
    Vector<dim> current_amplitude; ///< in the source's frame
    Vector<dim> field_amplitude;   ///< in the frame of own_field
    Matrix<dim> field_rotation;    ///< of the frame of own_field
  };
} // namespace magmpm
