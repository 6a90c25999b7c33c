#include "catch.h"

#include <magmpm/elliptic/tpetra_solver.h>

#include <algorithm>
#include <cmath>

using namespace magmpm;

namespace
{
  /** Rows n r/p to n (r+1)/p of the matrix tridiag(-1, 2, -1) of size n, on rank r of p. */
  class PoissonRows
  {
  public:
    explicit PoissonRows(const int n)
      : n(n)
    {
      int rank, n_ranks;
      MPI_Comm_rank(MPI_COMM_WORLD, &rank);
      MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
      first = n * rank / n_ranks;
      end   = n * (rank + 1) / n_ranks;

      std::vector<std::size_t> starts = {0};
      std::vector<TpetraSolver::GlobalIndex> columns;
      for (int row = first; row < end; ++row)
        {
          for (int column = std::max(row - 1, 0); column < std::min(row + 2, n); ++column)
            columns.push_back(column);
          starts.push_back(columns.size());
        }
      solver = std::make_unique<TpetraSolver>(MPI_COMM_WORLD, starts, columns);
    }

    /** As a sum over the edges between i and i + 1, so that the last one adds to a row of the next rank. */
    void
    assemble(const double scaling)
    {
      solver->start_assembly();
      const double values[2][2] = {{scaling, -scaling}, {-scaling, scaling}};
      for (TpetraSolver::GlobalIndex edge = first; edge < std::min(end, n - 1); ++edge)
        for (int i = 0; i < 2; ++i)
          {
            const TpetraSolver::GlobalIndex columns[2] = {edge, edge + 1};
            solver->add(edge + i, 2, columns, values[i]);
          }
      for (const TpetraSolver::GlobalIndex side : {0, n - 1})
        if (side >= first && side < end)
          solver->add(side, 1, &side, &scaling);
      solver->finish_assembly();
    }

    /** The right hand side of the solution 1 at scaling 1. */
    std::vector<double>
    right_hand_side() const
    {
      std::vector<double> values(end - first);
      for (int row = first; row < end; ++row)
        values[row - first] = (row == 0) + (row == n - 1);
      return values;
    }

    const int n;
    int first, end;
    std::unique_ptr<TpetraSolver> solver;
  };

  double
  largest_error(const std::vector<double> &values, const double exact)
  {
    double error = 0.;
    for (const double value : values)
      error = std::max(error, std::abs(value - exact));
    return error;
  }
} // namespace

// The one-dimensional Laplacian between boundary values 1 has the solution 1, and with twice the matrix
// 1/2: entries of other ranks arrive, and a kept hierarchy solves with the matrix as it is now.
TEST_CASE("Tpetra solves with the present matrix", "[elliptic][mpi]")
{
  PoissonRows rows(5000);
  const std::vector<double> right_hand_side = rows.right_hand_side();
  std::vector<double> solution(right_hand_side.size());

  rows.assemble(1.);
  rows.solver->rebuild_hierarchy();
  auto result = rows.solver->solve(right_hand_side.data(), 1e-12, 100, solution.data());
  CHECK(result.is_solved());
  CHECK(largest_error(solution, 1.) < 1e-6);

  rows.assemble(2.);
  result = rows.solver->solve(right_hand_side.data(), 1e-12, 100, solution.data());
  CHECK(result.is_solved());
  CHECK(largest_error(solution, 0.5) < 1e-6);
}

// Without enough iterations, and with a matrix for which CG is not made, the result says that there
// is none.
TEST_CASE("Tpetra says why it has no solution", "[elliptic][mpi]")
{
  PoissonRows rows(5000);
  const std::vector<double> right_hand_side = rows.right_hand_side();
  std::vector<double> solution(right_hand_side.size());

  rows.assemble(1.);
  rows.solver->rebuild_hierarchy();
  auto result = rows.solver->solve(right_hand_side.data(), 1e-12, 2, solution.data());
  CHECK_FALSE(result.is_solved());
  CHECK(result.iterations == 2);
  CHECK(result.failure == "in 2 iterations of CG");

  rows.assemble(-1.);
  result = rows.solver->solve(right_hand_side.data(), 1e-12, 100, solution.data());
  CHECK_FALSE(result.is_solved());
  CHECK_THAT(result.failure, Catch::Matchers::Contains("by Belos' CG, which stopped: "));
}
