#pragma once

#include <array>

namespace magmpm
{
  /** The box of the potential around the mechanical one. */
  template <int dim>
  struct MeshParameters
  {
    /** Whether the scene has magnetic material; if not the mesh only spreads the blocks over the ranks. */
    bool carries_potential = true;

    /** Edge of the potential box over the edge of the mechanical box, at least, where faces are open. */
    double potential_box_factor = 2.;

    /** Faces (-x, +x, -y, ...) where the potential box ends at the wall (mirror condition). */
    std::array<bool, 2 *dim> shielded = {};

    /** Edge of the cells where material is, in dx: 2 or 1. */
    int cell_edge = 2;

    /**
     * Cells are fine in the active blocks and this many blocks further, where the mesh changes; then
     * they stay until the active blocks are twice as far.
     */
    int band_width = 0;
  };
} // namespace magmpm
