#pragma once

#include <magmpm/materials/magnetization.h>

#include <optional>

namespace magmpm
{
  /** A magnetic fluid with surface tension, for what follows. */
  struct FerrofluidProperties
  {
    double density;         ///< rho [kg/m^3]
    double surface_tension; ///< gamma [N/m]
    double gravity;         ///< g [m/s^2]
    MagneticContent content;
  };

  /** sqrt(gamma/(rho g)) [m]: a critical wave is 2 pi times as long. */
  double
  capillary_length(const FerrofluidProperties &fluid);

  /** The uniform field in a flat layer, along its normal. */
  struct CriticalLayer
  {
    double magnetization; ///< M [A/m]
    double field;         ///< H inside [A/m]
    double induction;     ///< mu_0 (H + M) [T], inside and outside
  };

  /**
   * Above this a deep layer in a vertical field is unstable (Cowley and Rosensweig, J. Fluid Mech. 30, 1967):
   *   mu_0 M^2 = 2 (1 + 1/r) sqrt(rho g gamma),   r^2 = (1 + M/H) (1 + dM/dH),
   * in which r is mu/mu_0 if the law is linear.
   *
   * @return nothing if no field makes it unstable: M saturates below.
   */
  std::optional<CriticalLayer>
  critical_layer(const FerrofluidProperties &fluid, const MagnetizationModel &model);
} // namespace magmpm
