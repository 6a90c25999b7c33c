#pragma once

#include <magmpm/base/exceptions.h>

#include <mpi.h>

#include <functional>
#include <iosfwd>
#include <string>

namespace magmpm::parallel
{
  /** A file to whose end any rank can write why it failed; none until append_to(). */
  class FailureLog
  {
  public:
    /** From now on failures also go to the end of this file. Who else writes it has to append as well. */
    void
    append_to(const std::string &path)
    {
      this->path = path;
    }

    /** Adds the line "FAILED: text" to the file, if there is one. Never throws. */
    void
    write(const std::string &text) const noexcept;

  private:
    std::string path;
  };

  /**
   * Runs @p program on all ranks and turns its exceptions into one message and an exit code: 2 for
   * an InputError, 1 for every other exception.
   *
   * If all ranks failed, rank 0 prints its message, and all return the exit code. A rank that fails
   * alone would leave the others waiting for it: when they have not failed within two seconds too,
   * it prints its message and ends the program on all ranks by MPI_Abort with the exit code.
   *
   * The message goes to the log that the program named, too, by the rank that prints it: no other can,
   * rank 0 waits in MPI for the one that failed. For the same reason nobody tells rank 0 to write what
   * it still holds, so files that are to be complete after a failure are written row by row (one call
   * of the system for some kB).
   *
   * @param messages  where messages go (std::cerr; tests listen elsewhere).
   * @param program   called with the log, to name it as soon as it exists.
   */
  ExitCode
  report_errors(const MPI_Comm communicator,
                std::ostream &messages,
                const std::function<void(FailureLog &)> &program);

  /** As above, for a program without a log. */
  ExitCode
  report_errors(const MPI_Comm communicator,
                std::ostream &messages,
                const std::function<void()> &program);
} // namespace magmpm::parallel
