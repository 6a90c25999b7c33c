#pragma once

#include <magmpm/magnets/source_parts.h>

namespace magmpm
{
  /** Of a magnetized cylinder. */
  struct CylinderParameters
  {
    static constexpr Interior interior = Interior::may_be_solid;

    TimeFunction<Vector<3>> magnetization; ///< in its own frame [A/m]
    double radius = 0., length = 0.;       ///< [m]
    Vector<3> axis;                        ///< in its own frame, of any length; zero: along z
  };

  /**
   * A circular cylinder of radius R and length L about the axis z, with uniform magnetization M of any
   * direction. With Phi the integral of 1/(4 pi r) over its volume,
   *   H = (Hessian of Phi) M,
   * whose entries, and those of the third derivatives for the gradient, are integrals round the rims
   * of the two ends: complete elliptic integrals (RingIntegrals, RimIntegrals). For axial M this is the
   * field of Derby and Olbert, Am. J. Phys. 78, 229 (2010), less M inside; for M across the axis that of
   * Caciagli et al., J. Magn. Magn. Mater. 456, 423 (2018). The gradient is in closed form as well. The
   * error is some 1e-14 of M, which far away is (r/a)^3 of H.
   *
   * The surface belongs to the outside: within 1e-9 of the larger of R and L from it the field is that
   * just outside; H.n jumps there by M.n. At the two edges H grows like the logarithm of the distance and
   * its gradient like the inverse; the distance is never taken as less than 1e-4 of the smaller of R
   * and L, so both are finite everywhere. On the axis the limits are taken.
   */
  class Cylinder : public SourceField<3>
  {
  public:
    /** Both greater than 0 [m]. */
    Cylinder(const double radius, const double length);

    Vector<3>
    field(const Vector<3> &magnetization, const Vector<3> &point) const override;

    Matrix<3>
    field_gradient(const Vector<3> &magnetization, const Vector<3> &point) const override;

    bool
    is_inside(const Vector<3> &point) const override;

    /** M, which the field comes near to at the surface [A/m]. */
    Vector<3>
    strength(const Vector<3> &magnetization) const override;

    /** If M is along the axis. */
    bool
    is_axisymmetric(const Vector<3> &magnetization) const override;

    double
    reach() const override;

    /** By 5 Gauss points along the axis and in the square of the radius, and 10 round it. */
    std::optional<ForceAndTorque<3>>
    force_and_torque(const Vector<3> &magnetization, const ActingField<3> &acting) const override;

  private:
    /** Where a point is for the purposes of the field, moved off the surface if it lies in it. */
    struct Place;

    Place
    place(const Vector<3> &point) const;

    const double radius, half_length;
    const double surface_tolerance;   ///< [m]
    const double least_edge_distance; ///< [m]
    std::vector<VolumeElement<3>> elements;
  };

  /** @throw InputError  if a length is not positive; names the source. */
  SourceParts<3>
  make_parts(const CylinderParameters &parameters, const std::string &name);
} // namespace magmpm
