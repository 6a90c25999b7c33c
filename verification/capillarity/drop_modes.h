#pragma once

#include <complex>

/** Small oscillations of a drop in vacuum without gravity: Lamb, Hydrodynamics, 273 to 275 and 355. */
namespace magmpm::verification
{
  /** A drop, in 2D a disc (a long thread across the plane). */
  struct Drop
  {
    int dim                = 3;
    double radius          = 2e-3;   ///< R [m]
    double density         = 1020.;  ///< rho [kg/m^3]
    double surface_tension = 0.0245; ///< gamma [N/m]
    double viscosity       = 0.;     ///< nu, kinematic [m^2/s]

    /** sqrt(gamma/(rho R)) [m/s]. */
    double
    capillary_speed() const;
  };

  /**
   * omega [1/s] of the mode n without viscosity: the radius is R (1 + eps cos(n theta)) in 2D, R (1 + eps P_n(cos theta))
   * in 3D, and
   *   omega^2 = n (n^2 - 1) gamma/(rho R^3)  (2D),   n (n - 1) (n + 2) gamma/(rho R^3)  (3D).
   */
  double
  drop_frequency(const Drop &drop, const int n);

  /**
   * Damping [1/s] of the amplitude where viscosity is small, from the potential flow:
   *   2 n (n - 1) nu/R^2  (2D),   (n - 1) (2 n + 1) nu/R^2  (3D).
   */
  double
  drop_damping(const Drop &drop, const int n);

  /**
   * s [1/s] of exp(s t) with any viscosity that lets it swing, from the linearized equations of Navier and Stokes:
   * potential flow and rotation, I_n(m r) in 2D and I_(n+1/2)(m r)/sqrt(r) in 3D, m^2 = s/nu, with no shear at the
   * surface (Chandrasekhar, Hydrodynamic and Hydromagnetic Stability, 98).
   */
  std::complex<double>
  drop_rate(const Drop &drop, const int n);
} // namespace magmpm::verification
