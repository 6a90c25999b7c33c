// Time of one particle and step by phase: the kernels of magmpm and the plain loop, taking turns on
// one core. The last line is the ratio of the two for the elastic cube.
//
//   particle_step [--help]

#include <magmpm/base/simd.h>
#include <magmpm/base/version.h>
#include <magmpm/io/error_report.h>
#include <magmpm/io/number_text.h>

#include <deal.II/base/mpi.h>

#include <particle_step/options.h>
#include <particle_step/timed_step.h>
#include <sys/resource.h>

#include <cstdio>
#include <iostream>

using namespace magmpm;
using namespace magmpm::benchmarks;

namespace
{
  /** What the program has taken of the memory so far, at most [B]. */
  double
  peak_memory()
  {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return 1024. * static_cast<double>(usage.ru_maxrss);
  }

  /** Prints a row of ns per particle and step; returns the least time of all phases together. */
  double
  print_row(const std::string &name, const std::vector<PhaseTimes> &runs, const double per_step)
  {
    const auto print = [per_step](std::vector<double> seconds) {
      const Spread times = spread(std::move(seconds));
      std::printf(" | %6.1f %6.1f", per_step * times.least, per_step * times.median);
      return times.least;
    };
    std::printf("%-14s", name.c_str());
    for (int phase = 0; phase < n_phases; ++phase)
      {
        std::vector<double> seconds;
        for (const PhaseTimes &run : runs)
          seconds.push_back(run.seconds[phase]);
        print(seconds);
      }
    std::vector<double> totals;
    for (const PhaseTimes &run : runs)
      totals.push_back(run.total());
    const double least = print(totals);
    std::printf("\n");
    return least;
  }

  /** Measures both codes on a scene and prints what they took; returns the ratio of the totals. */
  double
  measure(const ParticleScene &scene, const StepOptions &options)
  {
    const std::size_t n_particles = scene.bodies[0].particles.size();
    const double memory_before    = peak_memory();
    const auto kernels            = make_kernel_step(scene);
    std::vector<PhaseTimes> kernel_times, plain_times;
    time_of_steps(*kernels, options.steps);
    const double memory = (peak_memory() - memory_before) / n_particles;
    const auto plain    = make_plain_step(scene);
    time_of_steps(*plain, options.steps);
    for (int n = 0; n < options.repeats; ++n)
      {
        plain_times.push_back(time_of_steps(*plain, options.steps));
        kernel_times.push_back(time_of_steps(*kernels, options.steps));
      }

    std::printf(
      "\n%s, %s particles\n%-14s", scene.name.c_str(), with_separators(n_particles).c_str(), "");
    for (const char *phase : phase_names)
      std::printf(" | %13s", phase);
    std::printf(" | %13s\n", "all");
    const double per_step       = 1e9 / (static_cast<double>(n_particles) * options.steps);
    const double plain_seconds  = print_row("plain loop", plain_times, per_step);
    const double kernel_seconds = print_row("magmpm", kernel_times, per_step);
    std::printf(
      "ratio %.3f; %.0f B of memory per particle\n", kernel_seconds / plain_seconds, memory);
    std::fflush(stdout);
    return kernel_seconds / plain_seconds;
  }

  void
  run_program(const StepOptions &options)
  {
    if (options.help)
      {
        std::cout << step_usage();
        return;
      }
    std::cout << version_string() << "\nns per particle and step, least and median of "
              << options.repeats << " times " << options.steps
              << " steps; computing time of one core, " << simd_instruction_set << std::endl;
    double ratio = 0.;
    for (const double n_particles : options.particles)
      {
        ratio = measure(elastic_cube(n_particles), options);
        measure(fluid_block(n_particles), options);
      }
    std::printf("ratio=%.3f\n", ratio);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(report_errors(MPI_COMM_WORLD, std::cerr, [&]() {
    run_program(parse_step_options({argv + 1, argv + argc}));
  }));
}
