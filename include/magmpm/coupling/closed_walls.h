#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/mesh/mirror_images.h>
#include <magmpm/particles/box_faces.h>

namespace magmpm
{
  /** All faces of the box that are walls, as mirrors of the fluids in front of them. */
  template <int dim>
  MirrorWalls<dim>
  closed_walls(const Lattice<dim> &lattice, const OpenFaces<dim> &open)
  {
    MirrorWalls<dim> walls;
    walls.n_cells = lattice.n_cells;
    for (std::size_t face = 0; face < open.size(); ++face)
      walls.is_mirror[face] = !open[face];
    return walls;
  }
} // namespace magmpm
