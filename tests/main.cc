// The main function of the test programs: every test may use MPI, with any number of ranks.

#include "run_tests.h"

#include <magmpm/parallel/reduce.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <sstream>

namespace
{
  /**
   * Runs the tests chosen on the command line. Rank 0 reports as Catch2 does; of the other ranks
   * only those with a failure are heard.
   */
  int
  run_tests_of_rank(int argc, char **argv, const unsigned int rank)
  {
    std::ostringstream report;
    std::streambuf *terminal = std::cout.rdbuf();
    if (rank > 0)
      std::cout.rdbuf(report.rdbuf());

    const int result = run_tests(argc, argv);

    std::cout.rdbuf(terminal);
    if (rank > 0 && result != 0)
      std::cerr << "rank " << rank << ":\n" << report.str() << std::flush;
    return result;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const unsigned int rank = magmpm::parallel::rank(MPI_COMM_WORLD);
  const int result        = run_tests_of_rank(argc, argv, rank);
  return magmpm::parallel::max(result, MPI_COMM_WORLD);
}
