#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/mesh/mesh_parameters.h>

namespace magmpm
{
  /** The box of the mesh: root cells, each a cube of 2^root_level blocks. */
  template <int dim>
  struct PotentialBox
  {
    int root_level     = 0;
    Index<dim> n_roots = {};
    Index<dim> lower   = {}; ///< block in the lower corner

    Index<dim>
    n_blocks() const;

    bool
    holds(const Index<dim> &block) const;

    /** The block of the box that is nearest to @p block. */
    Index<dim>
    nearest(Index<dim> block) const;
  };

  /**
   * The box around the mechanical one: the largest root cells that meet the shielded walls, then as
   * few of them as suffice.
   */
  template <int dim>
  PotentialBox<dim>
  potential_box(const Lattice<dim> &lattice, const MeshParameters<dim> &parameters);
} // namespace magmpm
