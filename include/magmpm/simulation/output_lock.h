#pragma once

#include <mpi.h>

#include <string>

namespace magmpm
{
  /**
   * Keeps a second run out of an output directory for as long as this object lives. The process of rank 0
   * holds the lock, on the directory itself: no file comes or stays, and a run that is killed leaves no
   * lock. On a file system that has no locks (some network ones) two runs are not noticed.
   */
  class OutputLock
  {
  public:
    /**
     * Collective.
     *
     * @param makes_directory  if there is none; otherwise nothing is locked then.
     * @throw InputError  on all ranks, if another run holds the lock.
     * @throw RunError    on all ranks, if the directory cannot be made.
     */
    OutputLock(const MPI_Comm communicator,
               const std::string &directory,
               const bool makes_directory);
    ~OutputLock();

    OutputLock(const OutputLock &) = delete;
    OutputLock &
    operator=(const OutputLock &) = delete;

  private:
    int descriptor = -1;
  };
} // namespace magmpm
