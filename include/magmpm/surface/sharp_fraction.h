#pragma once

#include <magmpm/mesh/block_partition.h>

#include <array>

namespace magmpm
{
  /**
   * Where some material is, sharper than P2G tells: node fields that quadratic B-splines interpolate to
   * points, where they give a fraction f of material, 1 inside and 0 outside with a transition of
   * about one dx,
   *
   *   v = the volume fraction less its smear: v - dx^2/4 Laplace_h v
   *   w = max of v over 5^dim nodes, within [1e-3, 1]: single particles and thin sheets do not vanish
   *   f = w g(v/w),  g(t) = smoothstep(clip(1/2 + (t - 1/2)/0.8)),   nu = grad v/|grad v|.
   *
   * f of v and w: sharp_profile.h.
   *
   * No bodies are told apart. All of it stands on the active blocks; material behind shielded walls is
   * the mirror image of that in front.
   */
  template <int dim>
  class SharpFraction
  {
  public:
    /** What field() holds. */
    struct Nodes
    {
      static constexpr NodeScalar<Nodes> volume = {0}; ///< v
      static constexpr NodeScalar<Nodes> full   = {1}; ///< w

      template <typename Function>
      static constexpr void
      for_each(Function &&f)
      {
        f(volume);
        f(full);
      }
    };

    /**
     * Collective.
     *
     * @param volumes  the volume fraction (volume_fraction.h) with its images behind shielded walls,
     *                 ghosts updated.
     */
    void
    reinit(const BlockPartition<dim> &partition, const NodeField<dim, SingleScalar> &volumes);

    /** v and w on the nodes; ghosts updated. */
    const NodeField<dim, Nodes> &
    field() const
    {
      return nodes;
    }

    /**
     * nu where the mean of grad v (x) grad v [1/dx^2] is this: its principal direction, of either sign. It
     * loses its length where grad v vanishes, in the middle of isolated particles.
     */
    static Vector<dim>
    normal(const Matrix<dim> &gradient_square);

    /** Owned nodes where w is at its lower bound although particles reach them: their f is too small. */
    unsigned long
    n_clipped() const
    {
      return clipped;
    }

  private:
    NodeField<dim, Nodes> nodes;
    unsigned long clipped = 0;
  };
} // namespace magmpm
