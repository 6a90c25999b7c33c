#pragma once

namespace magmpm::verification
{
  /** A pool of ferrofluid around a vertical wire with a current; Langevin law, close to saturation. */
  struct WireMeniscus
  {
    double current         = 2900.; ///< [A]
    int cells              = 32;    ///< of the lattice along an edge of the square pool
    int particles_per_edge = 2;
    double duration        = 0.5; ///< [s]
  };

  /** Mean heights of the surface over two rings round the wire, of radii 1/8 to 3/16 and 9/32 to 3/8 of the edge. */
  struct MeniscusHeights
  {
    double measured; ///< inner less outer, at the end, over the edge of the pool [-]
    double exact;    ///< the same by the formula
    double speed;    ///< root mean square at the end [m/s]
  };

  /**
   * Lets the pool, flat at first, come to rest with damping. M is along the surface, round the wire, so that
   * there is no traction on it, and at rest rho g h(r) = mu_0 int M dH up to H(r) = I/(2 pi r), but for a
   * constant (Rosensweig, Ferrohydrodynamics, 5.2).
   */
  MeniscusHeights
  meniscus_heights(const WireMeniscus &pool);
} // namespace magmpm::verification
