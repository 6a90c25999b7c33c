#include "../catch.h"

#include <magmpm/parallel/exchange.h>
#include <magmpm/parallel/gather.h>

#include <string>

using namespace magmpm;

namespace
{
  /** As many numbers as the rank, so that rank 0 has none. */
  std::vector<int>
  numbers_of(const unsigned int rank)
  {
    std::vector<int> numbers;
    for (unsigned int i = 0; i < rank; ++i)
      numbers.push_back(static_cast<int>(100 * rank + i));
    return numbers;
  }
} // namespace

// Each rank has a text and a vector of another length, one of them empty: all ranks get those of all,
// in the order of ranks, and one rank alone where it alone was to get them.
TEST_CASE("Values of all ranks come to all, or to one", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  const std::string text     = rank == 0 ? "" : "of rank " + std::to_string(rank);
  const auto texts           = parallel::all_gather(text, MPI_COMM_WORLD);
  const auto numbers         = parallel::all_gather(numbers_of(rank), MPI_COMM_WORLD);
  REQUIRE(texts.size() == n_ranks);
  REQUIRE(numbers.size() == n_ranks);
  for (unsigned int r = 0; r < n_ranks; ++r)
    {
      CHECK(texts[r] == (r == 0 ? "" : "of rank " + std::to_string(r)));
      CHECK(numbers[r] == numbers_of(r));
    }

  const unsigned int last = n_ranks - 1;
  const auto on_last      = parallel::gather(numbers_of(rank), MPI_COMM_WORLD, last);
  REQUIRE(on_last.size() == (rank == last ? n_ranks : 0));
  for (unsigned int r = 0; r < on_last.size(); ++r)
    CHECK(on_last[r] == numbers_of(r));
  CHECK(parallel::gather(1.5, MPI_COMM_WORLD) ==
        (rank == 0 ? std::vector<double>(n_ranks, 1.5) : std::vector<double>()));
}

// Numbers, lists and words of other lengths on every rank, so that what arrives can only be the
// sender's.
TEST_CASE("The value of one rank comes to all", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  // What the others had is forgotten, whatever its length.
  const unsigned int last = n_ranks - 1;
  CHECK(parallel::broadcast(rank, MPI_COMM_WORLD, last) == last);
  CHECK(parallel::broadcast(numbers_of(rank), MPI_COMM_WORLD, last) == numbers_of(last));
  CHECK(parallel::broadcast(std::string(rank + 1, 'x'), MPI_COMM_WORLD) == "x");
  CHECK(parallel::broadcast(std::string(rank, 'x'), MPI_COMM_WORLD) == "");
}

// Rank r sends to the ranks from r on, so that the last one hears of all and each of itself, and the
// entries name both. Pieces of 16 bytes, five of the seven entries' vectors' own and one of a rest,
// must arrive as one vector; and pieces shorter than an entry hold one.
TEST_CASE("Some ranks send to some, in pieces", "[parallel][mpi]")
{
  const unsigned int rank            = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks         = parallel::n_ranks(MPI_COMM_WORLD);
  const std::size_t n_bytes_of_piece = GENERATE(1u, 16u, 1000000u);
  std::map<unsigned int, std::vector<double>> outgoing;
  for (unsigned int to = rank; to < n_ranks; ++to)
    for (int i = 0; i < 7; ++i)
      outgoing[to].push_back(100. * rank + 10. * to + i);

  for (int repetition = 0; repetition < 3; ++repetition)
    {
      const auto incoming = parallel::exchange(outgoing, MPI_COMM_WORLD, n_bytes_of_piece);
      REQUIRE(incoming.size() == rank + 1);
      for (const auto &[from, numbers] : incoming)
        {
          REQUIRE(numbers.size() == 7);
          for (int i = 0; i < 7; ++i)
            CHECK(numbers[i] == 100. * from + 10. * rank + i);
        }
    }
}

// Nothing to anybody, then an empty list to the first rank: who takes part in a collective does so
// with empty hands, too.
TEST_CASE("An exchange without entries is one, too", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  // An empty vector arrives as one: the receiver may have to answer. Where nothing was sent, nothing
  // comes.
  std::map<unsigned int, std::vector<int>> outgoing;
  CHECK(parallel::exchange(outgoing, MPI_COMM_WORLD).empty());
  outgoing[0];
  const auto incoming = parallel::exchange(outgoing, MPI_COMM_WORLD);
  CHECK(incoming.size() == (rank == 0 ? n_ranks : 0));
  for (const auto &[from, numbers] : incoming)
    CHECK(numbers.empty());
}
