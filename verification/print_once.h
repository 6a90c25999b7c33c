#pragma once

#include <mpi.h>

#include <cstdio>

namespace magmpm::verification
{
  /** Prints a line of figures, on the first of all ranks only. */
  template <typename... Numbers>
  void
  print_once(const char *format, const Numbers... numbers)
  {
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank > 0)
      return;
    std::printf(format, numbers...);
    std::printf("\n");
  }
} // namespace magmpm::verification
