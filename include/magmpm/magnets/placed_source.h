#pragma once

#include <magmpm/magnets/magnetic_source.h>
#include <magmpm/magnets/source_parameters.h>

#include <memory>

namespace magmpm
{
  /** A source that has a place: a field in its own frame (SourceField), and where that frame is. */
  template <int dim>
  class PlacedSource : public MagneticSource<dim>
  {
  public:
    PlacedSource(const SourceParameters<dim> &parameters, SourceParts<dim> parts);

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

    void
    set_pose(const Pose<dim> &pose) override;

    const Shape<dim> *
    shape() const override;

    bool
    is_solid() const override;

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
    /** Puts the source where @p pose is. */
    void
    move_to(const Pose<dim> &pose);

    const SourceParts<dim> parts;
    const Matrix<dim>
      alignment; ///< turns the frame of the field, whose axis is z, into the source's
    const TimeFunction<Pose<dim>> pose_in_time;
    const TimeFunction<double> strength_in_time;
    const bool solid, refusing;
    bool is_moved_from_outside = false;

    Pose<dim> current_pose;
    Vector<dim> current_amplitude; ///< in the source's frame
    Vector<dim> field_amplitude;   ///< in the frame of the field
    Matrix<dim> field_rotation;    ///< of the frame of the field
  };
} // namespace magmpm
