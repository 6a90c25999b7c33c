#pragma once

namespace magmpm::verification
{
  /**
   * A magnetic block of 12 x 6 dx that lies on another, of 20 x 8 dx, which sticks to the floor; a magnet above them
   * is switched on within 20 ms. Both are elastic (20 kPa, 1000 kg/m^3), in 2D.
   */
  struct LiftedBlock
  {
    double pull  = 1.1; ///< force of the magnet on the block where it lies, over its weight
    int n_groups = 2;   ///< contact groups: with one they are welded
  };

  /** @return how far the centre of the block rises in 0.12 s [dx]. */
  double
  rise_of_block(const LiftedBlock &block);
} // namespace magmpm::verification
