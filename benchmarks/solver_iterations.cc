// What one linear system of the potential takes: CG iterations to 1e-8, time and memory, by
// susceptibility and preconditioner.
//
//   mpirun -np 2 solver_iterations [RADIUS IN CELLS, 8] [PRECONDITIONER ...]

#include "magnetics/sphere_solve.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <vector>

using namespace magmpm;
using namespace magmpm::test;

namespace
{
  struct Choice
  {
    int radius_in_cells = 8;
    std::vector<Preconditioner> preconditioners;
  };

  Choice
  read_arguments(const int argc, char **argv)
  {
    Choice choice;
    for (int i = 1; i < argc; ++i)
      {
        const auto *named = std::find_if(std::begin(all_preconditioners),
                                         std::end(all_preconditioners),
                                         [&](const Preconditioner p) {
                                           return std::string(to_string(p)) == argv[i];
                                         });
        if (named != std::end(all_preconditioners))
          choice.preconditioners.push_back(*named);
        else
          choice.radius_in_cells = std::stoi(argv[i]);
      }
    if (choice.preconditioners.empty())
      choice.preconditioners.assign(std::begin(all_preconditioners), std::end(all_preconditioners));
    return choice;
  }

  /** The most memory that this program has held so far, of all ranks [MB]. */
  double
  peak_memory()
  {
    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    return dealii::Utilities::MPI::sum(static_cast<double>(memory.VmHWM), MPI_COMM_WORLD) / 1024.;
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Choice choice = read_arguments(argc, argv);

  print_once(
    "Sphere of radius %d dx, linear law, %u ranks. Peak memory is of the program up to then: "
    "one preconditioner a run for figures to compare.",
    choice.radius_in_cells,
    dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  print_once("%-8s %6s %10s %5s %10s %8s %12s",
             "",
             "chi_0",
             "unknowns",
             "CG",
             "set-up s",
             "CG s",
             "peak MB");
  for (const Preconditioner preconditioner : choice.preconditioners)
    for (const double susceptibility : {1., 10., 100., 1000.})
      {
        const SphereSolve solve =
          solve_sphere<3>(preconditioner, susceptibility, choice.radius_in_cells);
        print_once("%-8s %6g %10llu %5d %10.3f %8.3f %12.0f",
                   to_string(preconditioner),
                   susceptibility,
                   solve.n_unknowns,
                   solve.newton.linear_iterations,
                   dealii::Utilities::MPI::max(solve.set_up_seconds, MPI_COMM_WORLD),
                   dealii::Utilities::MPI::max(solve.cg_seconds, MPI_COMM_WORLD),
                   peak_memory());
      }
}
