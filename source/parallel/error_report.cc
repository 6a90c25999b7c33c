#include <magmpm/parallel/error_report.h>
#include <magmpm/parallel/failure.h>
#include <magmpm/parallel/ranks.h>

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <ostream>
#include <thread>

namespace magmpm::parallel
{
  namespace
  {
    /** Whether all ranks come here within @p patience. */
    bool
    all_ranks_arrive(const MPI_Comm communicator, const std::chrono::duration<double> patience)
    {
      const auto start = std::chrono::steady_clock::now();
      int arrived      = 0;
      MPI_Request barrier;
      MPI_Ibarrier(communicator, &barrier);
      while (!arrived && std::chrono::steady_clock::now() - start < patience)
        {
          MPI_Test(&barrier, &arrived, MPI_STATUS_IGNORE);
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      return arrived;
    }
  } // namespace

  void
  FailureLog::write(const std::string &text) const noexcept
  {
    if (path.empty())
      return;
    // To the end as it is now, in one piece, whatever another process writes meanwhile.
    const int file = open(path.c_str(), O_WRONLY | O_APPEND);
    if (file < 0)
      return;
    const std::string line = "FAILED: " + text + "\n";
    // What cannot be written here was said on the terminal.
    [[maybe_unused]] const auto written = ::write(file, line.data(), line.size());
    close(file);
  }

  ExitCode
  report_errors(const MPI_Comm communicator,
                std::ostream &messages,
                const std::function<void(FailureLog &)> &program)
  {
    // Its own communicator, so that what a failed rank says meets no message of the others.
    MPI_Comm failures;
    MPI_Comm_dup(communicator, &failures);

    FailureLog log;
    const Failure failure = failure_of([&]() { program(log); });
    if (failure.exit_code == ExitCode::success)
      {
        MPI_Comm_free(&failures);
        return failure.exit_code;
      }

    // The lowest rank that failed loses patience first, and its abort silences the others.
    const unsigned int this_rank = rank(communicator);
    const std::chrono::duration<double> patience(2. + 0.1 * this_rank);
    const bool all_failed = all_ranks_arrive(failures, patience);
    if (this_rank == 0 || !all_failed)
      {
        const std::string who = all_failed ? "" : "rank " + std::to_string(this_rank) + ": ";
        messages << "magmpm: " << who << failure.message << std::endl;
        log.write(who + failure.message);
      }
    if (!all_failed)
      MPI_Abort(communicator, static_cast<int>(failure.exit_code));

    MPI_Comm_free(&failures);
    return failure.exit_code;
  }

  ExitCode
  report_errors(const MPI_Comm communicator,
                std::ostream &messages,
                const std::function<void()> &program)
  {
    return report_errors(communicator, messages, [&program](FailureLog &) { program(); });
  }
} // namespace magmpm::parallel
