#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** A block of one material that falls onto the floor of its box. */
  struct FallingBlock
  {
    std::string name;
    Lattice<3> lattice; ///< the floor is its lowest face
    std::vector<Body<3>> bodies;
    double time_step = 0.; ///< [s]
  };

  /**
   * The cube of the paper: neo-Hookean, 8 jittered particles a cell of dx = 1/128 m, one cell above
   * the floor, at 1 m/s downward.
   *
   * @param n_particles    about as many; 110,592 are 24 cells along an edge.
   * @param poisson_ratio  above 0.45 volumes are smoothed, see smoothed_volume.h.
   */
  FallingBlock
  elastic_cube(const double n_particles, const double poisson_ratio = 0.3);

  /** A block of viscous fluid of the same shape. */
  FallingBlock
  fluid_block(const double n_particles);

  inline constexpr double gravity = -9.81; ///< along z [m/s^2]
} // namespace magmpm::benchmarks
