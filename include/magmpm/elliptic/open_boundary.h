#pragma once

#include <deal.II/lac/full_matrix.h>

#include <magmpm/elliptic/elliptic_space.h>

#include <array>

namespace magmpm
{
  /**
   * Open space around the box, as a Robin condition on the total flux q,
   *   n.q = -c phi,  c = (m - 1) (n.r)/r^2,  r from the centre of the medium,
   * which is exact for the field of a dipole along n = r/r (m = dim) and keeps the problem symmetric
   * and positive definite. In the weak form it adds int c phi v, here as element matrices of the
   * cells at open faces: then hanging nodes, multigrid levels and diagonals are treated as for
   * every other part of the operator.
   *
   * Shielded faces have the natural condition n.q = 0, which is a mirror. The source of the
   * field outside is then the medium and its image: r starts on the mirror; and between two opposite
   * mirrors, in a row of images without end, only the components of r across the row count, m is
   * one less, for each such pair.
   *
   * Where nothing fixes the constant of the potential (all faces shielded, or m = 1) it is held by a
   * positive number on the diagonal of one corner of the box. The solution is the one that is zero
   * there, exactly: the right hand side is orthogonal to constants.
   */
  template <int dim>
  class OpenBoundary
  {
  public:
    using CellIterator = typename EllipticSpace<dim>::CellIterator;

    /**
     * @param centre    of the medium [m]; moved to the middle of the box if outside.
     * @param shielded  faces -x, +x, -y, ... of the box.
     */
    OpenBoundary(const EllipticSpace<dim> &space,
                 const std::array<bool, 2 * dim> &shielded,
                 const Vector<dim> &centre);

    /**
     * The element matrix of a cell of any level, in lexicographic numbering.
     *
     * @return whether there is one; if not, @p matrix is left alone.
     */
    bool
    element_matrix(const CellIterator &cell, dealii::FullMatrix<double> &matrix) const;

    /** Whether the constant is held at a corner of the box. */
    bool
    holds_constant() const
    {
      return !has_robin;
    }

    /** Where r starts: only the components that count. */
    const Vector<dim> &
    centre() const
    {
      return start;
    }

  private:
    Vector<dim> lower_corner, upper_corner;
    std::array<bool, 2 *dim> open = {};
    std::array<bool, dim> counts  = {}; ///< components of r
    Vector<dim> start;
    int decay      = 0; ///< m - 1
    bool has_robin = false;

    /** c [1/m] at a point of the face across @p axis; @p sign of the outward normal. */
    double
    coefficient(const Vector<dim> &point, const int axis, const int sign) const;

    void
    add_face(const CellIterator &cell,
             const int axis,
             const int side,
             dealii::FullMatrix<double> &matrix) const;
  };
} // namespace magmpm
