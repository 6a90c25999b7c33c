#pragma once

#include <magmpm/lattice/block_quadrature.h>

#include <array>

namespace magmpm
{
  /**
   * The stress of surfaces with tension in a block of the lattice,
   *   T = gamma (I - nu nu^T) |grad f|,   |grad f| = df/dv |grad v|,   nu = grad v/|grad v|,
   * with f of v and w (sharp_profile.h), by three points an axis in every cell of edge dx. With fewer points
   * particles find arrangements that these do not see, of less area than a circle, and a drop boils. The
   * integral of |grad f| over space is the area, for any monotone profile, so the width of the transition
   * costs an error of second order only.
   */
  template <int dim>
  class SurfaceStress
  {
  public:
    using NodeValues = typename BlockQuadrature<dim>::NodeValues;

    /** On the nodes around a block. */
    struct Nodes
    {
      NodeValues volume; ///< v
      NodeValues full;   ///< w

      /** Whether f is not 1 all over the block. */
      bool has_surface = true;

      /** Where tension differs from place to place, it is the ratio of these; else not looked at. */
      NodeValues tension, content;
      bool is_uniform = true;

      /** The share of rigid bodies, in which there is no stress; looked at if there are any. */
      NodeValues rigid;
      bool has_bodies = false;
    };

    /**
     * Adds f_i = -int T grad N_i over the block, in units of gamma dx^(dim-2), gamma that of the largest
     * tension.
     *
     * @return int |grad f| times the tension at each point over gamma [dx^(dim-1)].
     */
    double
    add_force(const Nodes &nodes, std::array<NodeValues, dim> &force) const;

  private:
    using PlaneValues = typename BlockQuadrature<dim>::PlaneValues;

    const BlockQuadrature<dim> rule;

    /** df/dv times tension, times weights. @return whether there is any. */
    bool
    find_slopes(const Nodes &nodes, const int plane, PlaneValues &slopes) const;

    /** Multiplies by the tension of each point. */
    void
    weigh_by_tension(const Nodes &nodes, const int plane, PlaneValues &slopes) const;

    /** Multiplies by 1 in front of rigid bodies, by 0 behind their surface, where the share is a half. */
    void
    cut_at_bodies(const Nodes &nodes, const int plane, PlaneValues &slopes) const;
  };
} // namespace magmpm
