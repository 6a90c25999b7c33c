#pragma once

namespace magmpm
{
  /**
   * Integrals round a ring of radius R about the axis z, seen from a point at the distance rho from the
   * axis and at the height z above the ring's plane. With phi the angle to the point and
   *   D^2 = z^2 + rho^2 + R^2 - 2 rho R cos(phi),
   * they make the fields of loops and cylinders, and are complete elliptic integrals of the modulus
   * k^2 = 4 rho R/D_max^2 (Carlson's forms, from Boost). For k^2 < 3/4 a midpoint rule of 16 points takes
   * their place, which converges like 3^-32 and loses nothing where they cancel, near the axis.
   */
  struct RingIntegrals
  {
    double potential; ///< integral of cos(phi)/D dphi, divided by rho [1/m^2]
    double axial;     ///< integral of R (R - rho cos(phi))/D^3 dphi [1/m]
    double radial;    ///< integral of R cos(phi)/D^3 dphi, divided by rho [1/m^3]
  };

  /** @param least_distance  from the ring: less is taken for this [m]. */
  RingIntegrals
  ring_integrals(const double radius,
                 const double rho,
                 const double height,
                 const double least_distance);

  /** First derivatives of the fields of a loop; the others follow from div H = 0 and curl H = 0. */
  struct RingDerivatives
  {
    double axial;  ///< d(RingIntegrals::axial)/dz [1/m^2]
    double radial; ///< d(rho z RingIntegrals::radial)/dz [1/m^2]
  };

  RingDerivatives
  ring_derivatives(const double radius,
                   const double rho,
                   const double height,
                   const double least_distance);

  /** Integrals as above over the rim of a disc, with s^2 = rho^2 + R^2 - 2 rho R cos(phi). */
  struct RimIntegrals
  {
    double angle;  ///< integral of (R^2 - rho R cos(phi))/(s^2 D) dphi [1/m]
    double across; ///< integral of sin^2(phi)/(s^2 D) dphi [1/m^3]
  };

  /** The sum of them has a jump, but no pole, at rho = R, where it is their mean. */
  RimIntegrals
  rim_integrals(const double radius,
                const double rho,
                const double height,
                const double least_distance);
} // namespace magmpm
