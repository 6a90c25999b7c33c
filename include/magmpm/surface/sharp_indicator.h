#pragma once

#include <magmpm/lattice/lattice_cells.h>
#include <magmpm/surface/sharp_fraction.h>

#include <array>
#include <functional>
#include <limits>
#include <vector>

namespace magmpm
{
  /**
   * Where material is in the octants of lattice cells: the fraction f and the normal nu of a
   * SharpFraction, and a correction q of the density of the material that makes its volume right,
   * locally,
   *
   *   q = sum_i N_i [S clip(A_i/W_i, 0.5, 5)],  A = S P2G(volumes),  W = S int f N_i,
   *
   * with S three passes of smooth(). S is symmetric and keeps sums, so int q f is the volume of the
   * particles wherever the clip is idle.
   *
   * All of it is evaluated at the points of a rule of 2^dim points in an octant, of which the octant has
   * the mean of f, that of q weighted with f, and as nu the principal direction of grad v (x) grad v. Then
   * part of q < 1 goes to f, which leaves q f: f <- f (1 + (1 - f^4) (q - 1)). The position of an octant is
   * its point of QGauss(2), moved as far as the centroid of its material lies from its middle.
   */
  template <int dim>
  class SharpIndicator
  {
  public:
    /** Stands for the first octant of a cell without material. */
    static constexpr unsigned int none = std::numeric_limits<unsigned int>::max();

    struct Octant
    {
      double fraction   = 0.; ///< f
      double correction = 1.; ///< q
      Vector<dim> normal;     ///< nu; zero in cells that have no surface
      Vector<dim> position;   ///< where its material is met by the field of sources [m]
    };

    /**
     * Finds all of it. Collective.
     *
     * @param volumes  P2G of the particle volumes over dx^dim, with its images behind shielded walls,
     *                 ghosts updated.
     * @param check    called with places [m] where material is found, all over the octants; it may throw.
     */
    void
    reinit(const BlockPartition<dim> &partition,
           const LatticeCells<dim> &cells,
           const NodeField<dim, SingleScalar> &volumes,
           const std::function<void(const Vector<dim> &)> &check);

    /** Number of the first of the n_octants<dim> octants of each cell, or none. */
    const std::vector<unsigned int> &
    first_octants() const
    {
      return first_octant_of_cell;
    }

    const Octant &
    octant(const unsigned int number) const
    {
      return octants[number];
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
    using Rule           = CellQuadrature<dim, 2 * n_octants_1d>;
    using PointFractions = std::array<double, Rule::size()>;
    using Check          = std::function<void(const Vector<dim> &)>;

    SharpFraction<dim> sharp;
    std::vector<unsigned int> first_octant_of_cell;
    std::vector<Octant> octants;
    std::vector<PointFractions> fractions; ///< by cell with material
    unsigned long clipped_corrections = 0;

    /** f at the points of a cell. @return whether there is any material. */
    bool
    find_fractions(const LatticeCells<dim> &cells,
                   const Rule &rule,
                   const unsigned int cell,
                   const Check &check,
                   PointFractions &f) const;

    /** Gives octants with f and positions to a cell with material, and adds int f N_i over dx^dim. */
    void
    add_cell(const LatticeCells<dim> &cells,
             const Rule &rule,
             const unsigned int cell,
             const Check &check,
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

    /** q in the octants of a cell with material. */
    void
    correct_octants(const LatticeCells<dim> &cells,
                    const Rule &rule,
                    const unsigned int cell,
                    const NodeField<dim, SingleScalar> &correction);

    /** nu in the octants of a cell that has a surface. */
    void
    find_normals(const LatticeCells<dim> &cells, const Rule &rule, const unsigned int cell);
  };
} // namespace magmpm
