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

    /** Cells are fine in the active blocks and, when the mesh changes, this many blocks further. */
    int band_width = 0;

    /** Load of the most loaded rank over the mean above which cells and particles are dealt out anew. */
    double imbalance_threshold = 1.2;
  };
} // namespace magmpm
