#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/particles/body.h>

#include <vector>

namespace magmpm
{
  /** What there is of material around each node, sums over particles of N_i V_0 over dx^dim. */
  struct SurfaceContent
  {
    static constexpr NodeScalar<SurfaceContent> volume  = {0}; ///< of all
    static constexpr NodeScalar<SurfaceContent> tension = {1}; ///< times their tension [N/m]
    static constexpr NodeScalar<SurfaceContent> square  = {2}; ///< times its square [N^2/m^2]
    static constexpr NodeScalar<SurfaceContent> fluid   = {3}; ///< of fluids

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(volume);
      f(tension);
      f(square);
      f(fluid);
    }
  };

  /** @param content  on return this rank's part, ghosts too. */
  template <int dim>
  void
  surface_content_to_lattice(std::vector<Body<dim>> &bodies,
                             const BlockSet<dim> &blocks,
                             const Lattice<dim> &lattice,
                             NodeField<dim, SurfaceContent> &content);
} // namespace magmpm
