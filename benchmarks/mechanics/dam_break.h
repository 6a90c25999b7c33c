#pragma once

#include <vector>

namespace magmpm::benchmarks
{
  /** The front of a collapsing column at an instant: T = t sqrt(2 g/a), Z = x/a. */
  struct DamFront
  {
    double time;      ///< T
    double measured;  ///< Z of the experiment
    double simulated; ///< Z of magmpm
  };

  /**
   * A column of water, a = 57.15 mm (2.25 inches) wide and 2 a high, collapses on a dry
   * ground to which it sticks, in plane strain. Its front is compared with the experiment of J. C. Martin and W. J.
   * Moyce, "An experimental study of the collapse of liquid columns on a rigid horizontal plane",
   * Phil. Trans. R. Soc. Lond. A 244 (1952) 312-324, figure 3, n^2 = 2, a = 2.25 inches, in the
   * numbers that the examples of PySPH (pysph/examples/db_exp_data.py) read from it, up to T = 4.04.
   *
   * @param cells  of the lattice along a.
   */
  std::vector<DamFront>
  dam_fronts(const int cells);

  /**
   * The largest |simulated - measured|/measured until T = 3.5. Later the front is a sheet much thinner than
   * it was in any cell of a lattice that one would take, and friction on the ground decides its speed.
   */
  double
  dam_front_error(const std::vector<DamFront> &fronts);
} // namespace magmpm::benchmarks
