#pragma once

namespace magmpm::verification
{
  /** A beam of length 1 that bends without stretching, clamped horizontally at its start. */
  struct Elastica
  {
    double mean_height = 0., mean_reach = 0.; ///< of its mass
    double height = 0., reach = 0.;           ///< of its end
    double angle = 0.;                        ///< of its end [rad]
  };

  enum class BeamLoad
  {
    weight, ///< th'' = -q (1 - s) cos th, q = rho g A L^3/(E I)
    couple ///< th'' = -q cos th, q = torque per length L^2/(E I): that of a magnet across its field
  };

  /** th(0) = 0, th'(1) = 0, by shooting, to 1e-7. */
  Elastica
  elastica(const double q, const BeamLoad load);
} // namespace magmpm::verification
