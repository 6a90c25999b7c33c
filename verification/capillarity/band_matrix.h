#pragma once

#include <cstddef>
#include <vector>

namespace magmpm::verification
{
  /** A symmetric positive definite matrix whose entries are near the diagonal; its lower half is stored. */
  class BandMatrix
  {
  public:
    /** @param width  entries (i, j) with |i - j| above it are zero. */
    BandMatrix(const int n, const int width);

    /** To the entry of row i and column j, i - width <= j <= i. */
    void
    add(const int i, const int j, const double value)
    {
      rows[static_cast<std::size_t>(i) * (width + 1) + (j - i + width)] += value;
    }

    /** Makes row and column i those of the identity. */
    void
    isolate(const int i);

    /** Replaces the matrix by its factor (Cholesky), as solve() needs it. */
    void
    factorize();

    /** Replaces the right hand side by the solution. */
    void
    solve(std::vector<double> &x) const;

  private:
    const int n, width;
    std::vector<double> rows;

    /** So that row(i)[j] is the entry of column j. */
    double *
    row(const int i)
    {
      return rows.data() + static_cast<std::ptrdiff_t>(i) * width + width;
    }

    const double *
    row(const int i) const
    {
      return rows.data() + static_cast<std::ptrdiff_t>(i) * width + width;
    }
  };
} // namespace magmpm::verification
