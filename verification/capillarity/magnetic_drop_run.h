#pragma once

#include <verification/capillarity/magnetic_spheroid.h>

#include <cstddef>

namespace magmpm::verification
{
  /**
   * A drop of linear ferrofluid of magmpm in a uniform field, without gravity, damped until it rests; in 3D a quarter, in
   * 2D half of it between mirrors along the field.
   */
  struct MagneticDropRun
  {
    MagneticDrop drop;
    double bond_number  = 1.;  ///< N = mu_0 H_0^2 R/gamma
    int cells           = 8;   ///< R/dx
    double start_aspect = 1.;  ///< of the spheroid that it is at first
    double sound        = 10.; ///< sqrt(K/rho), over sqrt(gamma/(rho dx))
    double damping      = 2.;  ///< Rest/Damping rate [U/R]
    double duration     = 10.; ///< [R/U]
    double room         = 3.;  ///< half the height of the box, over R, less 6 dx
  };

  /** Square roots of the ratio of second moments along and across the field, which of a spheroid is the aspect ratio. */
  struct MagneticDropAspect
  {
    double measured;    ///< mean of the last fifth
    double change;      ///< largest less least there
    double highest;     ///< particle over the centre [R]
    std::size_t n_lost; ///< particles that have left the box, since the start
  };

  MagneticDropAspect
  magnetic_drop_aspect(const MagneticDropRun &run);
} // namespace magmpm::verification
