#pragma once

namespace magmpm::verification
{
  /**
   * Angular momentum of an elastic block with APIC that spins and vibrates without gravity, for six turns.
   *
   * @param cells  of the lattice along an edge of the block.
   * @return the largest change of a component over the size of the angular momentum.
   */
  double
  angular_momentum_error(const int cells);
} // namespace magmpm::verification
