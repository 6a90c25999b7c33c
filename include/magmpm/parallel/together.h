#pragma once

#include <mpi.h>

#include <functional>
#include <string>

/** What may fail on some ranks only, such as writing to a disk: then it fails on all. */
namespace magmpm::parallel
{
  /**
   * Does @p action on all ranks. If it throws on any, all throw the same error: an InputError or a
   * RunError with what the lowest of these ranks has to say. Returns on no rank before the action is
   * done on all. Collective.
   *
   * The action itself must not be collective, or must fail on all ranks.
   */
  void
  together(const MPI_Comm communicator, const std::function<void()> &action);

  /** As above; the message begins with @p what was to be done and went wrong: "what: why.". */
  void
  together(const MPI_Comm communicator,
           const std::string &what,
           const std::function<void()> &action);

  /** Does @p action on rank 0 alone; all throw if it fails. Collective. */
  void
  on_first_rank(const MPI_Comm communicator, const std::function<void()> &action);

  /**
   * Makes a folder, and those around it, if there is none. Collective.
   *
   * @param content  what is to be in it, for the message: "the particles".
   */
  void
  make_folder(const MPI_Comm communicator, const std::string &path, const std::string &content);
} // namespace magmpm::parallel
