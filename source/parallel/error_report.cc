#include <magmpm/parallel/error_report.h>

#include <deal.II/base/exceptions.h>

#include <chrono>
#include <ostream>
#include <sstream>
#include <thread>

namespace magmpm
{
  namespace
  {
    struct Failure
    {
      ExitCode exit_code = ExitCode::success;
      std::string message;
    };

    /** What deal.II says about an error of its own, on one line and without its banner. */
    std::string
    in_one_line(const dealii::ExceptionBase &error)
    {
      std::ostringstream information;
      error.print_info(information);
      std::istringstream words(information.str());
      std::string text, word;
      while (words >> word)
        text += " " + word;
      return "an error in deal.II (" + std::string(error.get_exc_name()) + "):" + text;
    }

    Failure
    failure_of(const std::function<void()> &program)
    {
      try
        {
          program();
          return {};
        }
      catch (const InputError &error)
        {
          return {ExitCode::wrong_input, error.what()};
        }
      catch (const dealii::ExceptionBase &error)
        {
          return {ExitCode::failed_run, in_one_line(error)};
        }
      catch (const std::bad_alloc &)
        {
          return {ExitCode::failed_run, "the memory is full. Use larger cells, or more machines."};
        }
      catch (const std::exception &error)
        {
          return {ExitCode::failed_run, error.what()};
        }
      catch (...)
        {
          return {ExitCode::failed_run, "an exception of unknown type."};
        }
    }

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

  ExitCode
  report_errors(const MPI_Comm communicator,
                std::ostream &messages,
                const std::function<void()> &program)
  {
    // Its own communicator, so that what a failed rank says meets no message of the others.
    MPI_Comm failures;
    MPI_Comm_dup(communicator, &failures);
    int rank, n_ranks;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &n_ranks);

    const Failure failure = failure_of(program);
    if (failure.exit_code == ExitCode::success)
      {
        MPI_Comm_free(&failures);
        return failure.exit_code;
      }

    // The lowest rank that failed loses patience first, and its abort silences the others.
    const std::chrono::duration<double> patience(2. + 0.1 * rank);
    const bool together = all_ranks_arrive(failures, patience);
    if (rank == 0 || !together)
      messages << "magmpm: " << (together ? "" : "rank " + std::to_string(rank) + ": ")
               << failure.message << std::endl;
    if (!together)
      MPI_Abort(communicator, static_cast<int>(failure.exit_code));

    MPI_Comm_free(&failures);
    return failure.exit_code;
  }
} // namespace magmpm
