#pragma once

#include <magmpm/mesh/block_partition.h>

#include <array>

namespace magmpm
{
  /**
   * Where magnetic material is, sharper than P2G tells: node fields that B-splines interpolate to a
   * volume fraction f of material, 1 inside and 0 outside with a transition of about one dx, and to a
   * correction q of its density that makes the volume right, locally.
   *
   *   v = P2G of particle volumes over dx^dim, less its smear: v - dx^2/4 Laplace_h v
   *   w = max of v over 5^dim nodes, within [1e-3, 1]: what counts as full, so that single particles
   *       and thin sheets do not vanish
   *   f = w g(v/w),  g(t) = smoothstep(clip(1/2 + (t - 1/2)/0.8))
   *   q = sum_i N_i [S clip(A_i/W_i, 0.5, 5)],  A = S P2G(volumes),  W = S int f N_i,
   * with S three passes of smooth(). S is symmetric and keeps sums, so int q f is the volume of the
   * particles wherever the clip is idle. No bodies are told apart.
   *
   * All of it stands on the active blocks; material behind shielded walls is the mirror image of that
   * in front.
   */
  template <int dim>
  class SharpIndicator
  {
  public:
    /** Lanes of field(). */
    enum Lane
    {
      volume,    ///< v
      full,      ///< w
      correction ///< q
    };

    /**
     * Finds v and w; q is 1. Collective.
     *
     * @param content  lane 0: P2G of the particle volumes over dx^dim with its mirror images, ghosts
     *                 updated.
     */
    void
    reinit(const BlockPartition<dim> &partition,
           const Lattice<dim> &lattice,
           const std::array<bool, 2 * dim> &shielded,
           const NodeField<dim> &content);

    /**
     * Finds q. Collective.
     *
     * @param tested_fraction  lane 0: int f N_i over dx^dim from the cells of this rank, ghosts too.
     * @param content          as for reinit().
     */
    void
    set_correction(const BlockPartition<dim> &partition,
                   const Lattice<dim> &lattice,
                   const std::array<bool, 2 * dim> &shielded,
                   const NodeField<dim> &content,
                   NodeField<dim> &tested_fraction);

    /** v, w and q on the nodes, to be interpolated with quadratic B-splines; ghosts updated. */
    const NodeField<dim> &
    field() const
    {
      return nodes;
    }

    /** f at a point with these interpolated v and w. */
    static double
    fraction(const double volume, const double full);

    /** Owned nodes where w is at its lower bound although particles reach them: their f is too small. */
    unsigned long
    n_clipped_fractions() const
    {
      return clipped_fractions;
    }

    /** Owned nodes where A/W is outside of [0.5, 5]: the volume is not right there. */
    unsigned long
    n_clipped_corrections() const
    {
      return clipped_corrections;
    }

  private:
    NodeField<dim> nodes;
    unsigned long clipped_fractions   = 0;
    unsigned long clipped_corrections = 0;
  };
} // namespace magmpm
