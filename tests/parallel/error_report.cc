#include "../catch.h"
#include "../test_folder.h"

#include <magmpm/parallel/error_report.h>

#include <deal.II/base/exceptions.h>

#include <mpi.h>

#include <fstream>
#include <new>
#include <sstream>

using namespace magmpm;

namespace
{
  DeclException1(ExcTest, int, << "The number " << arg1 << "\nis wrong.");

  /** Exit code and message when all ranks do @p program. */
  std::pair<ExitCode, std::string>
  outcome_of(const std::function<void()> &program)
  {
    std::ostringstream messages;
    const ExitCode exit_code = parallel::report_errors(MPI_COMM_WORLD, messages, program);
    return {exit_code, messages.str()};
  }
} // namespace

// All ranks fail at once: the exit code tells wrong input (2) from a failed run (1) on every rank, and
// rank 0 alone says why, on one line, also when deal.II or the system threw.
TEST_CASE("An error that all ranks meet is told once", "[parallel][mpi]")
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  const auto heard = [rank](const std::string &text) { return rank == 0 ? text : ""; };

  const auto success = outcome_of([]() {});
  CHECK(success.first == ExitCode::success);
  CHECK(success.second == "");

  const auto input = outcome_of([]() { throw InputError("wrong value."); });
  CHECK(input.first == ExitCode::wrong_input);
  CHECK(input.second == heard("magmpm: wrong value.\n"));

  const auto run = outcome_of([]() { throw RunError("it ran away."); });
  CHECK(run.first == ExitCode::failed_run);
  CHECK(run.second == heard("magmpm: it ran away.\n"));

  const auto deal_ii = outcome_of([]() { AssertThrow(false, ExcTest(7)); });
  CHECK(deal_ii.first == ExitCode::failed_run);
  CHECK(deal_ii.second ==
        heard("magmpm: an error in deal.II (ExcTest(7)): The number 7 is wrong.\n"));

  const auto memory = outcome_of([]() { throw std::bad_alloc(); });
  CHECK(memory.first == ExitCode::failed_run);
  CHECK(memory.second ==
        heard("magmpm: the memory is full. Use larger cells, or more machines.\n"));
}

TEST_CASE("A failure of all ranks stands once in the log", "[parallel][mpi]")
{
  // The program names its log once it exists, and rank 0 holds it open. A line after the failure does
  // not overwrite it, since both append.
  const std::string log = testing::fresh_folder("error_report") + "/log.txt";
  std::ofstream held;
  if (testing::this_rank() == 0)
    {
      held.open(log, std::ios::app);
      held << "frame 1" << std::endl;
    }
  std::ostringstream messages;
  parallel::report_errors(MPI_COMM_WORLD, messages, [&](parallel::FailureLog &failures) {
    failures.append_to(log);
    throw RunError("it ran away.");
  });
  if (testing::this_rank() == 0)
    {
      held << "frame 2" << std::endl;
      CHECK(testing::contents(log) == "frame 1\nFAILED: it ran away.\nframe 2\n");
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_CASE("Any rank can write its failure, but makes no log", "[parallel][mpi]")
{
  // All ranks write at once to the same file: every line is whole. A file that is not there is not
  // made, and a log that was not named is none.
  const std::string folder = testing::fresh_folder("failure_log");
  parallel::FailureLog failures;
  CHECK_NOTHROW(failures.write("nobody hears"));
  failures.append_to(folder + "/missing/log.txt");
  CHECK_NOTHROW(failures.write("nobody hears"));
  CHECK(!std::filesystem::exists(folder + "/missing"));

  if (testing::this_rank() == 0)
    std::ofstream(folder + "/log.txt") << "frame 1\n";
  MPI_Barrier(MPI_COMM_WORLD);
  failures.append_to(folder + "/log.txt");
  failures.write("rank " + std::to_string(testing::this_rank()) + ": full");
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string text = testing::contents(folder + "/log.txt");
  for (int rank = 0; rank < testing::n_ranks(); ++rank)
    CHECK(text.find("\nFAILED: rank " + std::to_string(rank) + ": full\n") != std::string::npos);
}
