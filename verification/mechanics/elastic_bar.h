#pragma once

namespace magmpm::verification
{
  /**
   * Frequency of an elastic bar that is fixed at one end and free at the other: it starts to swing
   * along its axis when gravity pulls it there. Poisson's ratio is zero, so that it is a bar without
   * lateral inertia: f = sqrt(E/rho)/(4 L).
   *
   * @param cells  of the lattice along the bar, whose width is a quarter of its length.
   * @return relative error of the frequency, with its sign.
   */
  double
  frequency_error(const int cells);
} // namespace magmpm::verification
