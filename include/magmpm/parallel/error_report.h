#pragma once

#include <magmpm/base/exceptions.h>

#include <mpi.h>

#include <functional>
#include <iosfwd>

namespace magmpm
{
  /**
   * Runs @p program on all ranks and turns its exceptions into one message and an exit code: 2 for
   * an InputError, 1 for every other exception.
   *
   * If all ranks failed, rank 0 prints its message, and all return the exit code. A rank that fails
   * alone would leave the others waiting for it: when they have not failed within two seconds too,
   * it prints its message and ends the program on all ranks by MPI_Abort with the exit code.
   *
   * @param messages  where messages go (std::cerr; tests listen elsewhere).
   */
  ExitCode
  report_errors(const MPI_Comm communicator,
                std::ostream &messages,
                const std::function<void()> &program);
} // namespace magmpm
