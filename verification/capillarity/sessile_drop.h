#pragma once

#include <cstddef>

namespace magmpm::verification
{
  /**
   * Mean height over the wall, over the root mean square of x along it, of a circular (3D: spherical) cap that meets the wall
   * at an angle within the fluid [rad]. It rises with the angle.
   */
  double
  cap_ratio(const int dim, const double angle);

  /** The angle [rad] of a cap with this ratio. */
  double
  cap_angle(const int dim, const double ratio);

  /** Half a disc (3D: half a ball) that is laid on a wall, or on a rigid slab, along which fluids slip; no gravity. */
  struct SessileRun
  {
    int dim               = 2;
    double angle          = 60.; ///< contact angle of the wall, or of the slab [degrees]
    double slab           = 0.; ///< height of a rigid slab that it is laid on instead [dx]; 0: none
    int cells             = 12; ///< R/dx of the half disc
    double laplace_number = 120.; ///< rho gamma 2 R/mu^2
    double sound          = 10.;  ///< sqrt(K/rho), over sqrt(gamma/(rho dx))
    double duration       = 12.;  ///< [R/U]
    int particles_per_edge = 3;
  };

  /** Of the later third of the run [degrees]. */
  struct SessileDrop
  {
    double angle;          ///< mean
    double least, largest; ///< while it swings
    std::size_t n_lost;    ///< particles that have left the box along the wall, since the start
  };

  /** A quarter of it in 3D, half of it in 2D, between mirrors. */
  SessileDrop
  sessile_drop(const SessileRun &run);
} // namespace magmpm::verification
