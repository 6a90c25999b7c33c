#pragma once

namespace magmpm::verification
{
  /**
   * A bar of 6 h x h, h = 4 cells, in free space and plane strain. Grips on its outer h drive it to a stretch
   * and back again, in 20 of its first periods and without damping; across it is free.
   */
  struct StretchedBar
  {
    double poisson_ratio  = 0.49;
    double offset         = 0.; ///< from the lattice, in both directions [dx]
    double stretch        = 1.5;
    double periods        = 20.;
    double elastic_factor = 0.4;
  };

  /** Of the whole run, while the bar is held at its largest stretch. */
  struct StretchErrors
  {
    double force; ///< of the grips, relative error against that of the stretch that the places show
    double stress; ///< likewise, of the particles' own stress
    double noise;  ///< rms of (1 - S)^2 p, p the Kirchhoff pressure, S by quadratic B-splines [E]
    double gained; ///< the largest energy less work, of the largest work; zero at the start
    double rise;   ///< the most that it rose above its lowest value so far, likewise
  };

  /**
   * The exact bar of the same middle third: stretched by l along and a across, with no stress across,
   *   mu (a^2 - 1) + lambda ln(l a) = 0,   force/h = (mu (l^2 - 1) + lambda ln(l a))/l.
   */
  StretchErrors
  errors_of_stretching(const StretchedBar &bar);
} // namespace magmpm::verification
