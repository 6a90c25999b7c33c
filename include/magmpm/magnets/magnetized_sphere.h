#pragma once

#include <magmpm/magnets/magnetic_source.h>
#include <magmpm/magnets/motion_script.h>
#include <magmpm/magnets/source_parameters.h>

namespace magmpm
{
  /**
   * A sphere of radius R with uniform, rigid magnetization M: a permanent magnet, that may move and
   * may be solid. With r, n the distance and direction from its centre,
   *   inside:   H = -M/dim,
   *   outside:  H = (R/r)^dim (dim (M.n) n - M)/dim,
   * in 3D the field of a dipole of moment M 4/3 pi R^3. In 2D it is a cylinder magnetized across
   * its axis, outside a line dipole. The surface itself belongs to the outside, so that material
   * that lies on a solid magnet feels its field; H.n jumps there by M.n.
   */
  template <int dim>
  class MagnetizedSphere : public MagneticSource<dim>
  {
  public:
    /**
     * @throw InputError  if position or magnetization cannot be parsed, or the radius is not
     *                    positive.
     */
    explicit MagnetizedSphere(const SourceParameters<dim> &parameters);

    void
    set_time(const double time) override;

    Vector<dim>
    field(const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &point) const override;

    bool
    is_constant() const override;

    /** (dim-1)/dim M, the field at a pole [A/m]. */
    Vector<dim>
    strength() const override;

    /** [m] */
    Vector<dim>
    centre() const override;

    /** Of the centre [m/s]; the sphere does not spin. */
    Vector<dim>
    velocity() const
    {
      return current_velocity;
    }

    /** [m] */
    double
    radius() const
    {
      return sphere_radius;
    }

    /** M [A/m]. */
    Vector<dim>
    magnetization() const
    {
      return current_magnetization;
    }

    /** M times the volume [A m^2]; in 2D per metre of depth [A m]. */
    Vector<dim>
    moment() const;

    /** What material does at the surface; none: the sphere is not solid. */
    ContactCondition
    contact() const
    {
      return contact_condition;
    }

  private:
    MotionScript<dim> position_script;
    MotionScript<dim> magnetization_script;
    const double sphere_radius;
    const ContactCondition contact_condition;

    Vector<dim> current_centre;
    Vector<dim> current_velocity;
    Vector<dim> current_magnetization;
  };
} // namespace magmpm
