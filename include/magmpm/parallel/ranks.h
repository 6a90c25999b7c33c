#pragma once

#include <mpi.h>

/**
 * What the ranks of a communicator do together, on <mpi.h> alone: sums and extremes of anything that
 * lists its numbers (reduce.h), exchanges (gather.h, exchange.h), actions that fail on all ranks or on
 * none (together.h), and how a failure ends the program (error_report.h).
 */
namespace magmpm::parallel
{
  /** The number of this rank, from zero. */
  inline unsigned int
  rank(const MPI_Comm communicator)
  {
    int rank;
    MPI_Comm_rank(communicator, &rank);
    return static_cast<unsigned int>(rank);
  }

  /** How many ranks there are. */
  inline unsigned int
  n_ranks(const MPI_Comm communicator)
  {
    int n_ranks;
    MPI_Comm_size(communicator, &n_ranks);
    return static_cast<unsigned int>(n_ranks);
  }
} // namespace magmpm::parallel
