#pragma once

#include <magmpm/magnets/current_element.h>
#include <magmpm/magnets/source_parts.h>

namespace magmpm
{
  /** Of a circular current loop. */
  struct CurrentLoopParameters
  {
    static constexpr Interior interior = Interior::open;

    TimeFunction<double> current;              ///< round its axis by the right hand [A]
    double radius = 0., conductor_radius = 0.; ///< [m]
    Vector<3> axis;                            ///< in its own frame, of any length; zero: along z
  };

  /**
   * A circular loop of radius R about the axis z with the current I, counterclockwise seen from above.
   * With phi the angle to the point, D its distance from the loop's points, rho that from the axis,
   *   H_z = I/(4 pi) int R (R - rho cos(phi))/D^3 dphi,   H_rho = I/(4 pi) int R z cos(phi)/D^3 dphi,
   * complete elliptic integrals (Jackson, Classical Electrodynamics, section 5.5; RingIntegrals); on the
   * axis H_z = I R^2/(2 (R^2 + z^2)^(3/2)). The gradient is their derivative. Relative error 1e-13.
   *
   * The conductor is round, of radius a < R. Inside of it the field goes to zero linearly towards its
   * middle, as that of a uniform current in a straight one does: H is that at the point of its surface
   * straight outward, times the distance from the middle over a.
   */
  class CurrentLoop : public SourceField<3>
  {
  public:
    /** Both greater than 0, that of the conductor the smaller one [m]. */
    CurrentLoop(const double radius, const double conductor_radius);

    /** @param current  [A], the first component. */
    Vector<3>
    field(const Vector<3> &current, const Vector<3> &point) const override;

    Matrix<3>
    field_gradient(const Vector<3> &current, const Vector<3> &point) const override;

    /** I/(2 pi a) along the axis, the field at the surface of the conductor [A/m]. */
    Vector<3>
    strength(const Vector<3> &current) const override;

    bool
    is_axisymmetric(const Vector<3> &current) const override;

    double
    reach() const override;

    /** By 64 pieces. */
    std::optional<ForceAndTorque<3>>
    force_and_torque(const Vector<3> &current, const ActingField<3> &acting) const override;

  private:
    const double radius, conductor_radius;
    std::vector<CurrentElement> elements;
  };

  /** @throw InputError  if a length is not positive; names the source. */
  SourceParts<3>
  make_parts(const CurrentLoopParameters &parameters, const std::string &name);
} // namespace magmpm
