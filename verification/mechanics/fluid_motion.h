#pragma once

namespace magmpm::verification
{
  /**
   * How often walls held a particle of water that sloshes for a second in a tank, in gravity that leans over.
   */
  double
  held_in_slosh();

  /**
   * The same of jets that are thrown at all faces of the box and into its corners, at 0.6 of the speed of sound
   * (3D: 0.4); the sum over walls that stick, slip and separate.
   */
  double
  held_jets(const int dim);

  /** Two drops, discs of 10 cells, that meet in free fall at 0.8 m/s and fall on as one, in 2D. */
  struct MergingDrops
  {
    double momentum; ///< largest change of that across the fall, over what it is
    double path;     ///< of the centre of mass at the end, less its fall [dx]
    double
      energy_rise; ///< largest rise of the sum of energies, over the kinetic energy of the impact
  };

  MergingDrops
  merging_drops();

  /**
   * An elastic block on the slippery floor of a pool in 2D; a free rigid paddle dips in and stirs. Until the water
   * reaches the side walls nothing pushes along the floor.
   *
   * @return the largest change of the momentum of all along the floor, over that of the paddle at the start.
   */
  double
  momentum_change_of_stirred_pool();
} // namespace magmpm::verification
