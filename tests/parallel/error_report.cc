#include "../catch.h"

#include <magmpm/parallel/error_report.h>

#include <deal.II/base/exceptions.h>

#include <mpi.h>

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
    const ExitCode exit_code = report_errors(MPI_COMM_WORLD, messages, program);
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
