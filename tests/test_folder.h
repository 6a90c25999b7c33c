#pragma once

#include <mpi.h>

#include <verification/text_file.h>

#include <filesystem>
#include <string>

namespace magmpm::testing
{
  using verification::contents;

  inline int
  this_rank()
  {
    int rank;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
  }

  inline int
  n_ranks()
  {
    int size;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    return size;
  }

  /**
   * An empty folder of one test and number of ranks (tests may run side by side), in the folder
   * that the tests are started in. Collective.
   */
  inline std::string
  fresh_folder(const std::string &test)
  {
    const std::string folder = "test-output/" + test + "-np" + std::to_string(n_ranks());
    if (this_rank() == 0)
      {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
      }
    MPI_Barrier(MPI_COMM_WORLD);
    return folder;
  }
} // namespace magmpm::testing
