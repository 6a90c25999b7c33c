#include <magmpm/parallel/failure.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/parallel/together.h>

#include <filesystem>

namespace magmpm::parallel
{
  namespace
  {
    /** What went wrong on the lowest rank where something did, on all ranks. Collective. */
    Failure
    first_failure(const MPI_Comm communicator, const Failure &failure)
    {
      const unsigned int n = n_ranks(communicator);
      const unsigned int failed =
        min(failure.exit_code == ExitCode::success ? n : rank(communicator), communicator);
      if (failed == n)
        return {};
      return {broadcast(failure.exit_code, communicator, failed),
              broadcast(failure.message, communicator, failed)};
    }

    void
    raise(const Failure &failure)
    {
      if (failure.exit_code == ExitCode::wrong_input)
        throw InputError(failure.message);
      if (failure.exit_code != ExitCode::success)
        throw RunError(failure.message);
    }
  } // namespace

  void
  together(const MPI_Comm communicator, const std::function<void()> &action)
  {
    raise(first_failure(communicator, failure_of(action)));
  }

  void
  together(const MPI_Comm communicator,
           const std::string &what,
           const std::function<void()> &action)
  {
    Failure failure = first_failure(communicator, failure_of(action));
    failure.message = what + ": " + failure.message + ".";
    raise(failure);
  }

  void
  on_first_rank(const MPI_Comm communicator, const std::function<void()> &action)
  {
    together(communicator, [&]() {
      if (rank(communicator) == 0)
        action();
    });
  }

  void
  make_folder(const MPI_Comm communicator, const std::string &path, const std::string &content)
  {
    on_first_rank(communicator, [&]() {
      std::error_code error;
      std::filesystem::create_directories(path, error);
      if (error)
        throw RunError("The folder '" + path + "' for " + content +
                       " cannot be made. Are you allowed to write there?");
    });
  }
} // namespace magmpm::parallel
