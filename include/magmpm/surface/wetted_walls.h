#pragma once

#include <magmpm/mesh/mirror_images.h>
#include <magmpm/surface/surface_stress.h>

#include <array>

namespace magmpm
{
  /** What each wall of the box does to a surface that meets it. */
  template <int dim>
  struct WettedWalls
  {
    MirrorWalls<dim> mirrors;               ///< all that are walls
    std::array<bool, 2 *dim> sticks   = {}; ///< material does not move along them
    std::array<double, 2 *dim> cosine = {}; ///< of the contact angle

    /** Whether a face of a block in the box lies on a wall with another contact angle than 90 degrees. */
    bool
    wets(const int face, const Index<dim> &block) const
    {
      const int outermost = (face % 2 == 0 ? 0 : mirrors.n_cells[face / 2] / block_edge - 1);
      return cosine[face] != 0. && block[face / 2] == outermost;
    }
  };

  /**
   * Adds the force of wetted walls on the nodes around a block. The wall has the surface energy
   * -gamma cos(theta), so that it acts on what wets it like a membrane of that tension,
   *   f_i = gamma cos(theta) int_wall f grad_t N_i dA,
   * in units of gamma dx^(dim-2), by the points of BlockQuadrature on the wall.
   *
   * @return the energy of the walls of the block, over gamma dx^(dim-1).
   */
  template <int dim>
  double
  add_wall_tension(const WettedWalls<dim> &walls,
                   const Index<dim> &block,
                   const typename SurfaceStress<dim>::Nodes &nodes,
                   std::array<typename SurfaceStress<dim>::NodeValues, dim> &force);
} // namespace magmpm
