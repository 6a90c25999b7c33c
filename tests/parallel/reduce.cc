#include "../catch.h"

#include <magmpm/parallel/reduce.h>

#include <array>
#include <cmath>
#include <limits>

using namespace magmpm;

namespace
{
  enum class Colour : int
  {
    red,
    green,
    blue
  };

  /** A struct with all that numbers may be. */
  struct Sample
  {
    double mass     = 0.;
    std::size_t n   = 0;
    Vector<3> force = {};
    Matrix<2> inertia;
    std::vector<std::array<float, 2>> pairs = {{{1.f, 2.f}}, {{3.f, 4.f}}};
    bool is_held                            = false;
    std::string name                        = "no number";

    template <typename F>
    void
    for_each_number(F &&f)
    {
      f(mass);
      f(n);
      f(force);
      f(inertia);
      f(pairs);
      f(is_held);
    }
  };
} // namespace

// A constant adds up to itself times the ranks, and is its own largest and smallest. A sum over
// 0, 1, ... n-1 is n (n - 1)/2.
TEST_CASE("Numbers are summed, maximized and minimized over ranks", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  CHECK(parallel::sum(0.25, MPI_COMM_WORLD) == 0.25 * n_ranks);
  CHECK(parallel::sum(rank, MPI_COMM_WORLD) == n_ranks * (n_ranks - 1) / 2);
  CHECK(parallel::max(0.25, MPI_COMM_WORLD) == 0.25);
  CHECK(parallel::max(static_cast<int>(rank) - 7, MPI_COMM_WORLD) == static_cast<int>(n_ranks) - 8);
  CHECK(parallel::min(-1. - rank, MPI_COMM_WORLD) == -1. * n_ranks);
  CHECK(parallel::max(rank == 0 ? Colour::blue : Colour::red, MPI_COMM_WORLD) == Colour::blue);
  CHECK(parallel::any(rank + 1 == n_ranks, MPI_COMM_WORLD));
  CHECK(!parallel::any(false, MPI_COMM_WORLD));
  CHECK(parallel::sum(std::vector<double>(), MPI_COMM_WORLD).empty());
}

// Counts are added as integers: 2^53 + 1 is no double, and the sum of ranks that have one each has to
// be exact. A long vector, of more than a message of 1 MB, is added entry by entry.
TEST_CASE("Large counts and long vectors are added exactly", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  const std::size_t count    = (std::size_t(1) << 53) + 1;
  CHECK(parallel::sum(count, MPI_COMM_WORLD) == count * n_ranks);

  std::vector<double> numbers(100000);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<double>(i) * (rank + 1);
  numbers            = parallel::sum(numbers, MPI_COMM_WORLD);
  bool all_are_right = true;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    all_are_right = all_are_right && numbers[i] == i * (0.5 * n_ranks * (n_ranks + 1));
  CHECK(all_are_right);
}

// A struct lists its numbers, whatever they are in; what it does not list stays. Every number is
// combined with the same one of the other ranks: rank r has r + (place of the number).
TEST_CASE("A struct is reduced number by number", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  Sample sample;
  sample.mass          = rank;
  sample.n             = rank + 1;
  sample.force         = {{rank + 2., rank + 3., rank + 4.}};
  sample.inertia(0, 1) = rank + 5.;
  sample.is_held       = (rank == 0);
  const double ranks   = 0.5 * n_ranks * (n_ranks - 1.);

  const Sample sum = parallel::sum(sample, MPI_COMM_WORLD);
  CHECK(sum.mass == ranks);
  CHECK(sum.n == static_cast<std::size_t>(ranks) + n_ranks);
  for (int d = 0; d < 3; ++d)
    CHECK(sum.force[d] == ranks + (2 + d) * n_ranks);
  CHECK(sum.inertia(0, 0) == 0.);
  CHECK(sum.inertia(0, 1) == ranks + 5 * n_ranks);
  CHECK(sum.pairs[1][1] == 4.f * n_ranks);
  CHECK(sum.is_held);
  CHECK(sum.name == "no number");
  CHECK(parallel::max(sample, MPI_COMM_WORLD).force[2] == n_ranks + 3.);
  CHECK(parallel::min(std::vector<Sample>(2, sample), MPI_COMM_WORLD)[1].inertia(0, 1) == 5.);
}

// Sums and extremes go in the same exchange, and each number gets what was asked for it. What was named
// before it had its value counts with the value that it has when the exchange takes place.
TEST_CASE("One exchange sums, maximizes and minimizes", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  double sum = 0., largest = rank, smallest = rank;
  std::size_t n = 1;
  parallel::Reduction reduction;
  reduction.sum(sum);
  reduction.max(largest);
  reduction.min(smallest);
  reduction.sum(n);
  sum = 2.;
  reduction.carry_out(MPI_COMM_WORLD);
  CHECK(sum == 2. * n_ranks);
  CHECK(largest == n_ranks - 1.);
  CHECK(smallest == 0.);
  CHECK(n == n_ranks);

  // It is empty now.
  reduction.carry_out(MPI_COMM_WORLD);
  CHECK(n == n_ranks);
}

// The run-away check relies on it: a NaN on one rank is what all ranks get, as the largest and as the
// smallest number, whichever rank has it. Infinities order as numbers do.
TEST_CASE("NaN survives", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  for (unsigned int bad = 0; bad < n_ranks; ++bad)
    {
      const double value = (rank == bad ? std::nan("") : 1. + rank);
      CHECK(std::isnan(parallel::max(value, MPI_COMM_WORLD)));
      CHECK(std::isnan(parallel::min(value, MPI_COMM_WORLD)));
      CHECK(std::isnan(parallel::sum(value, MPI_COMM_WORLD)));
    }
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(parallel::max(rank == 0 ? -infinity : 1., MPI_COMM_WORLD) ==
        (n_ranks == 1 ? -infinity : 1.));
  CHECK(parallel::max(rank == 0 ? infinity : 1., MPI_COMM_WORLD) == infinity);
}
