// What the solution of the potential takes, by preconditioner, for a sphere in an adaptive mesh: one
// linear system, by susceptibility (CG iterations to 1e-8, time, memory); and all of Newton's method to
// 1e-10 at the paper's values, from zero and as the sphere moves on by 0.1 dx a frame.
//
//   mpirun -np 2 solver_iterations [RADIUS IN CELLS, 8] [PRECONDITIONER ...]

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <magmpm/parallel/ranks.h>
#include <magmpm/parallel/reduce.h>

#include <verification/magnetostatics/sources.h>
#include <verification/magnetostatics/sphere_solve.h>
#include <verification/print_once.h>

#include <algorithm>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;

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
    return parallel::sum(static_cast<double>(memory.VmHWM), MPI_COMM_WORLD) / 1024.;
  }

  void
  print_linear_systems(const Choice &choice)
  {
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
                     parallel::max(solve.set_up_seconds, MPI_COMM_WORLD),
                     parallel::max(solve.cg_seconds, MPI_COMM_WORLD),
                     peak_memory());
        }
  }

  struct TimedSolve
  {
    SolveReport report;
    double seconds; ///< of the slowest rank
  };

  TimedSolve
  timed_solve(SampledSetup<3> &scene, const ExternalField<3> &sources)
  {
    const double start       = MPI_Wtime();
    const SolveReport report = scene.problem.solve(scene.content, sources);
    return {report, parallel::max(MPI_Wtime() - start, MPI_COMM_WORLD)};
  }

  void
  print_timed(const Preconditioner preconditioner, const char *frame, const TimedSolve &solve)
  {
    print_once("%-8s %-12s %10llu %7d %5d %9.3f",
               to_string(preconditioner),
               frame,
               solve.report.n_unknowns,
               solve.report.newton.steps,
               solve.report.newton.linear_iterations,
               solve.seconds);
  }

  /** The paper's material, at a = 3.3 in the outer field. */
  void
  print_newton_solves(const Choice &choice)
  {
    constexpr double spacing = 0.01, field_strength = 1e5, k2 = 3.31e-5, chi = 0.91;
    constexpr int n_frames = 10;
    const double radius    = choice.radius_in_cells * spacing;
    Vector<3> field;
    field[2] = field_strength;
    const ExternalField<3> sources({uniform_source<3>(field)});
    print_once("%-8s %-12s %10s %7s %5s %9s", "", "frame", "unknowns", "Newton", "CG", "s");
    for (const Preconditioner preconditioner : choice.preconditioners)
      {
        MagneticsParameters<3> parameters;
        parameters.solver.preconditioner = preconditioner;
        SampledSetup<3> scene(4 * choice.radius_in_cells, spacing, 8., parameters);
        TimedSolve best = {{}, 1e300};
        for (int frame = 0; frame <= n_frames; ++frame)
          {
            Vector<3> centre;
            for (int d = 0; d < 3; ++d)
              centre[d] = 2. * radius + 0.13 * spacing * (d + 1);
            centre[2] += 0.1 * spacing * frame;
            scene.set_bodies({sphere<3>(centre, radius, {3. * chi / k2, chi})}, 3);
            const TimedSolve solve = timed_solve(scene, sources);
            if (frame == 0)
              print_timed(preconditioner, "first", solve);
            else if (solve.seconds < best.seconds && solve.report.relative_initial_residual() < 1.)
              best = solve;
          }
        print_timed(preconditioner, "later", best);
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Choice choice = read_arguments(argc, argv);

  print_once(
    "Sphere of radius %d dx, %u ranks. Linear law, one system to 1e-8. Peak memory is of the "
    "program up to then: one preconditioner a run for figures to compare.",
    choice.radius_in_cells,
    parallel::n_ranks(MPI_COMM_WORLD));
  print_linear_systems(choice);
  print_once(
    "Langevin law, Newton's method to 1e-10: the first solve with its set-up, the best of 10 "
    "later ones, moved by 0.1 dx each.");
  print_newton_solves(choice);
}
