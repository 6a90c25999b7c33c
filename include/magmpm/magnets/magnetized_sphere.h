#pragma once

#include <magmpm/magnets/source_parts.h>

namespace magmpm
{
  /** Of a magnetized sphere; in 2D a cylinder magnetized across its axis. */
  template <int dim>
  struct MagnetizedSphereParameters
  {
    static constexpr Interior interior = Interior::may_be_solid;

    TimeFunction<Vector<dim>> magnetization; ///< in its own frame [A/m]
    double radius = 0.;                      ///< [m]
  };

  /**
   * A sphere of radius R with uniform, rigid magnetization M: a permanent magnet. With r, n the
   * distance and direction from its centre,
   *   inside:   H = -M/dim,
   *   outside:  H = (R/r)^dim (dim (M.n) n - M)/dim,
   * in 3D the field of a dipole of moment M 4/3 pi R^3. In 2D it is a cylinder magnetized across
   * its axis, outside a line dipole. The surface itself belongs to the outside, so that material
   * that lies on a solid magnet feels its field; H.n jumps there by M.n.
   */
  template <int dim>
  class MagnetizedSphere : public SourceField<dim>
  {
  public:
    /** @param radius  greater than 0 [m]. */
    explicit MagnetizedSphere(const double radius);

    Vector<dim>
    field(const Vector<dim> &magnetization, const Vector<dim> &point) const override;

    Matrix<dim>
    field_gradient(const Vector<dim> &magnetization, const Vector<dim> &point) const override;

    bool
    is_inside(const Vector<dim> &point) const override;

    /** (dim-1)/dim M, the field at a pole [A/m]. */
    Vector<dim>
    strength(const Vector<dim> &magnetization) const override;

    bool
    is_axisymmetric(const Vector<dim> &magnetization) const override;

    double
    reach() const override;

    /** Of the dipole in the centre: exact if what acts has its sources outside of the sphere. */
    std::optional<ForceAndTorque<dim>>
    force_and_torque(const Vector<dim> &magnetization,
                     const ActingField<dim> &acting) const override;

  private:
    const double radius;
  };

  /** @throw InputError  if a length is not positive; names the source. */
  template <int dim>
  SourceParts<dim>
  make_parts(const MagnetizedSphereParameters<dim> &parameters, const std::string &name);
} // namespace magmpm
