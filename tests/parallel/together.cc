#include "../catch.h"
#include "../test_folder.h"

#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/ranks.h>
#include <magmpm/parallel/together.h>

#include <filesystem>
#include <fstream>
#include <new>

using namespace magmpm;

// One rank alone fails, the last: all throw an error of the same kind with the same words, so that
// none is left waiting for another. Where none fails, none throws, and all have done their part.
TEST_CASE("What fails on one rank fails on all", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  int n_done                 = 0;
  CHECK_NOTHROW(parallel::together(MPI_COMM_WORLD, [&]() { ++n_done; }));
  CHECK(n_done == 1);

  const auto only_last = [&](const auto &error) {
    return [=]() {
      if (rank + 1 == n_ranks)
        throw error;
    };
  };
  CHECK_THROWS_AS(parallel::together(MPI_COMM_WORLD, only_last(InputError("no"))), InputError);
  CHECK_THROWS_AS(parallel::together(MPI_COMM_WORLD, only_last(RunError("no"))), RunError);
  CHECK_THROWS_WITH(parallel::together(MPI_COMM_WORLD, only_last(std::runtime_error("no disk"))),
                    "no disk");
  CHECK_THROWS_WITH(parallel::together(MPI_COMM_WORLD, only_last(std::bad_alloc())),
                    Catch::Contains("the memory is full"));
  CHECK_THROWS_WITH(
    parallel::together(MPI_COMM_WORLD, "nothing was written", only_last(RunError("no disk"))),
    "nothing was written: no disk.");
  CHECK_NOTHROW(parallel::together(MPI_COMM_WORLD, "nothing was written", []() {}));
}

// Several ranks fail at once with different words; all must throw the same, so one is chosen, the
// lowest.
TEST_CASE("The lowest rank that fails is heard", "[parallel][mpi]")
{
  const unsigned int rank    = parallel::rank(MPI_COMM_WORLD);
  const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
  // All ranks but the first fail, each with its own words.
  const auto fail = [&]() {
    if (rank > 0 || n_ranks == 1)
      throw RunError("rank " + std::to_string(rank));
  };
  CHECK_THROWS_WITH(parallel::together(MPI_COMM_WORLD, fail),
                    "rank " + std::to_string(n_ranks == 1 ? 0 : 1));
}

// Only rank 0 acts, and its failure is thrown on all: else the others would wait for it forever.
TEST_CASE("The first rank acts alone, and all know", "[parallel][mpi]")
{
  const unsigned int rank = parallel::rank(MPI_COMM_WORLD);
  bool has_acted          = false;
  parallel::on_first_rank(MPI_COMM_WORLD, [&]() { has_acted = true; });
  CHECK(has_acted == (rank == 0));
  CHECK_THROWS_WITH(parallel::on_first_rank(MPI_COMM_WORLD, []() { throw RunError("full"); }),
                    "full");
}

// One rank makes folders for all; what prevents it is the same error on all.
TEST_CASE("A folder is made, or all say why not", "[parallel][mpi]")
{
  const unsigned int rank = parallel::rank(MPI_COMM_WORLD);
  // A file is where the folder should be, so it cannot be made; beside it, it can, with its parents,
  // and is there on all ranks at once.
  const std::string folder = testing::fresh_folder("make_folder");
  if (rank == 0)
    std::ofstream(folder + "/file") << "no folder";
  parallel::make_folder(MPI_COMM_WORLD, folder + "/a/b", "the particles");
  CHECK(std::filesystem::is_directory(folder + "/a/b"));
  CHECK_NOTHROW(parallel::make_folder(MPI_COMM_WORLD, folder + "/a/b", "the particles"));
  CHECK_THROWS_WITH(parallel::make_folder(MPI_COMM_WORLD, folder + "/file/a", "the particles"),
                    "The folder '" + folder +
                      "/file/a' for the particles cannot be made. Are you allowed to write there?");
}
