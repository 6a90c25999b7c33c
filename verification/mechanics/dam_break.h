#pragma once

#include <vector>

namespace magmpm::verification
{
  /** The front of a collapsing column at an instant: T = t sqrt(2 g/a), Z = x/a. */
  struct DamFront
  {
    double time;      ///< T
    double measured;  ///< Z of the experiment
    double inviscid;  ///< Z without viscosity: inviscid_fronts()
    double simulated; ///< Z of magmpm: 99.5 % of the water is behind
    double foremost;  ///< Z of the foremost particle
  };

  /**
   * A column of water, a = 57.15 mm (2.25 inches) wide and 2 a high, collapses on a dry, slippery
   * ground, in plane strain. Its front is compared with the experiment of J. C. Martin and W. J.
   * Moyce, "An experimental study of the collapse of liquid columns on a rigid horizontal plane",
   * Phil. Trans. R. Soc. Lond. A 244 (1952) 312-324, figure 3, n^2 = 2, a = 2.25 inches, in the
   * numbers that the examples of PySPH (pysph/examples/db_exp_data.py) read from it, up to T = 4.03, and with
   * the collapse without viscosity, to which it is nearer: of water so shallow the ground slows the front down.
   *
   * @param cells  of the lattice along a.
   */
  std::vector<DamFront>
  dam_fronts(const int cells);

  /** The largest |simulated - inviscid|/inviscid. */
  double
  inviscid_front_error(const std::vector<DamFront> &fronts);

  /**
   * The largest |simulated - measured|/measured until T = 3.5, when it has gone 4 a. Later friction on
   * the ground, which there is none of here, slows the thin sheet in front down.
   */
  double
  dam_front_error(const std::vector<DamFront> &fronts);
} // namespace magmpm::verification
