#pragma once

#include <magmpm/elliptic/linear_solve_result.h>

#include <mpi.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace magmpm
{
  /**
   * A symmetric positive definite matrix in Trilinos' Tpetra, with Belos' conjugate gradients and
   * MueLu's smoothed aggregation. Rows lie on ranks in ascending contiguous ranges, as deal.II numbers
   * degrees of freedom.
   *
   * All of it is on Tpetra's default node: with a Trilinos whose Kokkos was built for CUDA, matrix,
   * hierarchy and CG are on the GPU, and what comes in and goes out here is copied. This file includes
   * no deal.II header, so that it can be compiled with such a Trilinos, whatever deal.II was built
   * with.
   */
  class TpetraSolver
  {
  public:
    using GlobalIndex = long long; ///< the one that Trilinos instantiates by default

    /**
     * The zero matrix. Collective.
     *
     * @param row_starts  of this rank's rows in @p columns, and the end of the last row.
     * @param columns     where the rows have entries, by global index.
     */
    TpetraSolver(const MPI_Comm communicator,
                 const std::vector<std::size_t> &row_starts,
                 const std::vector<GlobalIndex> &columns);
    ~TpetraSolver();

    /** Makes the matrix zero, for add(). Collective. */
    void
    start_assembly();

    /** Adds to entries of one row, of this or another rank. */
    void
    add(const GlobalIndex row, const int n, const GlobalIndex *columns, const double *values);

    /** Sends what was added to rows of other ranks. Collective. */
    void
    finish_assembly();

    /**
     * Aggregates anew for the matrix as it is. The hierarchy keeps a copy of it, so that it remains a
     * fixed and positive definite preconditioner when the matrix changes. Collective.
     *
     * @throw RunError with MueLu's own words if it fails.
     */
    void
    rebuild_hierarchy();

    /**
     * Solves for @p solution, starting from zero. Collective.
     *
     * @param right_hand_side, solution  the values of this rank's rows.
     * @param tolerance                  on the norm of the residual, absolute.
     */
    LinearSolveResult
    solve(const double *right_hand_side,
          const double tolerance,
          const int max_iterations,
          double *solution) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace magmpm
