#pragma once

#include <magmpm/lattice/lattice_cells.h>
#include <magmpm/surface/sharp_fraction.h>

#include <functional>
#include <limits>
#include <vector>

namespace magmpm
{
  /**
   * Where material is at the quadrature points of lattice cells: the fraction f and the normal nu of a
   * SharpFraction, and a correction q of the density of the material that makes its volume right,
   * locally,
   *
   *   q = sum_i N_i [S clip(A_i/W_i, 0.5, 5)],  A = S P2G(volumes),  W = S int f N_i,
   *
   * with S three passes of smooth(). S is symmetric and keeps sums, so int q f is the volume of the
   * particles wherever the clip is idle.
   */
  template <int dim>
  class SharpIndicator
  {
  public:
    /** Stands for the first point of a cell without material. */
    static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    struct Point
    {
      double fraction   = 0.; ///< f
      double correction = 1.; ///< q
      Vector<dim> normal;     ///< nu; zero in cells that have no surface
    };

    /**
     * Finds all of it. Collective.
     *
     * @param volumes      P2G of the particle volumes over dx^dim, with its images behind shielded walls,
     *                     ghosts updated.
     * @param is_excluded  whether a place [m] is no place for material, although particles may be there;
     *                     the correction makes up for it.
     */
    void
    reinit(const BlockPartition<dim> &partition,
           const LatticeCells<dim> &cells,
           const NodeField<dim, SingleScalar> &volumes,
           const std::function<bool(const Vector<dim> &)> &is_excluded);

    /** Number of the first of the n_points<dim> points of each cell, or none. */
    const std::vector<unsigned int> &
    first_points() const
    {
      return first_point_of_cell;
    }

    const Point &
    point(const unsigned int number) const
    {
      return points[number];
    }

    /** Owned nodes where f is too small, see SharpFraction. */
    unsigned long
    n_clipped_fractions() const
    {
      return sharp.n_clipped();
    }

    /** Owned nodes where A/W is outside of [0.5, 5]: the volume is not right there. */
    unsigned long
    n_clipped_corrections() const
    {
      return clipped_corrections;
    }

  private:
    SharpFraction<dim> sharp;
    std::vector<unsigned int> first_point_of_cell;
    std::vector<Point> points;
    unsigned long clipped_corrections = 0;

    /** Gives points with f to a cell, if there is any material in it, and adds int f N_i over dx^dim. */
    void
    find_fractions(const LatticeCells<dim> &cells,
                   const unsigned int cell,
                   const std::function<bool(const Vector<dim> &)> &is_excluded,
                   NodeField<dim, SingleScalar> &tested_fraction);

    /**
     * Makes q on nodes, ghosts too, of int f N_i over dx^dim from the cells of this rank.
     *
     * @param field  both.
     */
    void
    find_correction(const BlockPartition<dim> &partition,
                    const NodeField<dim, SingleScalar> &volumes,
                    NodeField<dim, SingleScalar> &field);

    /** q and nu at the points of a cell with material. */
    void
    complete_points(const LatticeCells<dim> &cells,
                    const unsigned int cell,
                    const NodeField<dim, SingleScalar> &correction);
  };
} // namespace magmpm
