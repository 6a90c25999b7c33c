#pragma once

#include <magmpm/surface/surface_stress.h>

#include <array>

namespace magmpm
{
  /**
   * The tension of what wets rigid bodies. A body has the surface energy -gamma cos(theta) where it is wet, so
   * that it acts on what wets it like a membrane of that tension,
   *   T = -gamma cos(theta) (I - n n^T) delta f,   f_i = -int T grad N_i.
   * Its place is where the share s of nodes in the body goes from 0 to 1: delta is |grad s|, n along grad s.
   *
   * T is symmetric, so that it adds neither to the sum nor to the torque of the forces: what holds the nodes
   * at the body hands its reaction on.
   */
  template <int dim>
  class WettedBodies
  {
  public:
    using Nodes      = typename SurfaceStress<dim>::Nodes;
    using NodeValues = typename SurfaceStress<dim>::NodeValues;

    /**
     * Adds f_i over the block, in units of gamma dx^(dim-2).
     *
     * @param wetting  on the nodes around it: the sum over bodies of s cos(theta).
     * @return the energy of the surfaces over gamma dx^(dim-1).
     */
    double
    add_force(const Nodes &nodes,
              const NodeValues &wetting,
              std::array<NodeValues, dim> &force) const;

  private:
    using PlaneValues = typename BlockQuadrature<dim>::PlaneValues;

    const BlockQuadrature<dim> rule;

    /** cos(theta) f delta/|grad s| at the points of a plane, times weights. */
    void
    find_strength(const Nodes &nodes,
                  const NodeValues &wetting,
                  const int plane,
                  const PlaneValues &share,
                  PlaneValues &strength) const;
  };
} // namespace magmpm
