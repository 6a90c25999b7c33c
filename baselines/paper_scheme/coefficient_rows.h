#pragma once

#include <baselines/paper_scheme/node_grid.h>

#include <vector>

namespace magmpm::paper_scheme
{
  /**
   * The seven-point part of the Jacobian (five points in 2D), sum_a G_a^T w_a G_a: on every node j
   * and axis a the conductance w_a(j) that couples the nodes j - e_a and j + e_a; zero where j lies
   * on a face across a, whose row of G is zero (the paper's Neumann condition).
   *
   * Lines of nodes without material all point to the same row of constants, which stays in the
   * first cache: there the matrix takes no memory traffic at all.
   */
  template <int dim>
  class CoefficientRows
  {
  public:
    explicit CoefficientRows(const NodeGrid<dim> &grid);

    /** As without material: w = dx^(dim-2)/4. */
    void
    clear();

    /** Makes w of @p axis at @p node @p factor times that of the vacuum. */
    void
    scale(const int axis, const Index<dim> &node, const double factor);

    /**
     * w of @p axis on a line of nodes; may be read one node before and beyond the line. Lines one
     * layer out of the box, along @p axis, are zero.
     */
    const double *
    row(const int axis, const std::ptrdiff_t line) const
    {
      return rows[axis][line + margin];
    }

    /** w in the vacuum [m^(dim-2)]. */
    double
    vacuum() const
    {
      return vacuum_value;
    }

    /** The diagonal of the matrix on a line: at each node the sum of the w of its neighbours. */
    void
    diagonal(const std::ptrdiff_t line, double *values) const
    {
      const int n             = grid.n_nodes(0);
      const double *const row = this->row(0, line);
      for (int x = 0; x < n; ++x)
        values[x] = row[x - 1] + row[x + 1];
      for (int a = 1; a < dim; ++a)
        {
          const double *const below = this->row(a, line - line_stride(a));
          const double *const above = this->row(a, line + line_stride(a));
          for (int x = 0; x < n; ++x)
            values[x] += below[x] + above[x];
        }
    }

    /** Distance of the numbers of two lines that are neighbours along @p axis > 0. */
    std::ptrdiff_t
    line_stride(const int axis) const
    {
      return axis == 1 ? 1 : grid.n_nodes(1);
    }

  private:
    const NodeGrid<dim> grid;
    const std::ptrdiff_t margin; ///< lines out of the box on either side
    const double vacuum_value;
    std::vector<double> zeros, constants, constants_along; ///< rows without material
    std::vector<const double *> rows[dim];
    std::vector<std::vector<double>> stored; ///< rows with material
    std::vector<int> slots[dim];             ///< of each line in these, or none
    static constexpr int none = -1;

    const double *
    vacuum_row(const int axis, const std::ptrdiff_t line) const;
  };
} // namespace magmpm::paper_scheme
