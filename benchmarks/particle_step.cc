// Time of one particle and step by phase: the kernels of magmpm and the plain loop, taking turns on
// one core. The last line is the ratio of the two for the (first) elastic cube.
//
//   particle_step [--help]

#include <magmpm/base/number_text.h>
#include <magmpm/base/simd.h>
#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <particle_step/memory_growth.h>
#include <particle_step/options.h>
#include <particle_step/timed_step.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

using namespace magmpm;
using namespace magmpm::benchmarks;

namespace
{
  /** Prints a row of ns per particle and step; returns the least of all phases together. */
  double
  print_row(const std::string &name, const std::vector<PhaseTimes> &runs, const double per_step)
  {
    const auto print = [per_step](std::vector<double> seconds) {
      const Spread times = spread(std::move(seconds));
      std::printf(" | %6.1f %6.1f", per_step * times.least, per_step * times.median);
      return per_step * times.least;
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

  /** ns per particle and step, all phases together. */
  struct Cost
  {
    double plain, kernels;
  };

  bool
  is_solid(const FallingBlock &block)
  {
    return std::visit([](const auto &law) { return law.stores_deformation_gradient; },
                      block.bodies[0].material);
  }

  /**
   * Measures both codes on a block and prints what they took.
   *
   * @param smoothed  the same block of a nearly incompressible solid, to be measured beside it.
   */
  Cost
  measure(const FallingBlock &block,
          const StepOptions &options,
          const FallingBlock *const smoothed = nullptr)
  {
    const std::size_t n_particles = block.bodies[0].particles.size();
    const MemoryGrowth memory;
    const auto kernels = make_kernel_step(block);
    std::vector<PhaseTimes> kernel_times, plain_times, fmpm_times, smoothed_times;
    time_of_steps(*kernels, options.steps);
    const double bytes = memory.bytes() / static_cast<double>(n_particles);
    const auto plain   = make_plain_step(block);
    time_of_steps(*plain, options.steps);
    const auto fmpm = is_solid(block) ? make_kernel_step(block, Transfer::fmpm) : nullptr;
    if (fmpm)
      time_of_steps(*fmpm, options.steps);
    const auto smoothed_fmpm = smoothed != nullptr ? make_kernel_step(*smoothed, Transfer::fmpm)
                                                   : nullptr;
    if (smoothed_fmpm)
      time_of_steps(*smoothed_fmpm, options.steps);
    for (int n = 0; n < options.repeats; ++n)
      {
        plain_times.push_back(time_of_steps(*plain, options.steps));
        kernel_times.push_back(time_of_steps(*kernels, options.steps));
        if (fmpm)
          fmpm_times.push_back(time_of_steps(*fmpm, options.steps));
        if (smoothed_fmpm)
          smoothed_times.push_back(time_of_steps(*smoothed_fmpm, options.steps));
      }

    std::printf(
      "\n%s, %s particles\n%-14s", block.name.c_str(), with_separators(n_particles).c_str(), "");
    for (const char *phase : phase_names)
      std::printf(" | %13s", phase);
    std::printf(" | %13s\n", "all");
    const double per_step = 1e9 / (static_cast<double>(n_particles) * options.steps);
    Cost cost;
    cost.plain             = print_row("plain loop", plain_times, per_step);
    cost.kernels           = print_row("magmpm", kernel_times, per_step);
    const double fmpm_cost = fmpm ? print_row("magmpm, FMPM", fmpm_times, per_step) : 0.;
    if (smoothed_fmpm)
      std::printf("nearly incompressible over FMPM %.3f\n",
                  print_row("nu = 0.49", smoothed_times, per_step) / fmpm_cost);
    std::printf("ratio %.3f; %.0f B of memory per particle\n", cost.kernels / cost.plain, bytes);
    std::fflush(stdout);
    return cost;
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
    std::vector<Cost> cube_costs;
    for (const double n_particles : options.particles)
      {
        const FallingBlock smoothed = elastic_cube(n_particles, 0.49);
        cube_costs.push_back(measure(elastic_cube(n_particles), options, &smoothed));
        measure(fluid_block(n_particles), options);
      }
    if (cube_costs.size() > 1)
      {
        const auto [least, largest] = std::minmax_element(
          cube_costs.begin(), cube_costs.end(), [](const Cost &a, const Cost &b) {
            return a.kernels < b.kernels;
          });
        std::printf("\nelastic cube: largest cost of a particle over the least %.2f\n",
                    largest->kernels / least->kernels);
      }
    std::printf("ratio=%.3f\n", cube_costs[0].kernels / cube_costs[0].plain);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_WORLD, std::cerr, [&]() {
    run_program(parse_step_options({argv + 1, argv + argc}));
  }));
}
