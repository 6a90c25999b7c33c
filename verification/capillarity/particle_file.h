#pragma once

#include <array>
#include <functional>
#include <string>

namespace magmpm::verification
{
  /** Places of particles on a grid of their own, each moved at random. */
  struct ParticleGrid
  {
    int dim        = 2;
    double spacing = 1.; ///< of the grid, whose first places are half of it from the origin [m]
    std::array<double, 3> upper = {};  ///< where it ends [m]
    double jitter               = 0.5; ///< random offset over half the spacing, at most
    unsigned int seed           = 1;
  };

  /**
   * Writes those places that are inside to NAME.csv, for a body whose shape is points. They are moved first, so
   * that the surface is known to a part of the spacing only, wherever it lies on the lattice.
   *
   * @param place  moves a place on, after it was found inside.
   * @return the file's name.
   */
  std::string
  write_particles(const std::string &name,
                  const ParticleGrid &grid,
                  const std::function<bool(const std::array<double, 3> &)> &is_inside,
                  const std::function<void(std::array<double, 3> &)> &move = {});
} // namespace magmpm::verification
