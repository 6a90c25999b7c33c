// Time of the magnetic part against its error: magmpm with each preconditioner, cell size and
// indicator, and the scheme of the paper, all on one core, taking turns, on the same particles.
//
//   speed_against_error [--help]

#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <speed_against_error/options.h>
#include <speed_against_error/speed_table.h>

#include <cmath>
#include <iostream>
#include <optional>

using namespace magmpm;
using namespace magmpm::benchmarks;

namespace
{
  using paper_scheme::BoxFaces;

  constexpr int resolutions[] = {2, 3, 4, 6, 8, 12, 16, 24, 32};

  std::vector<Contender>
  all_contenders(const double tolerance)
  {
    std::vector<Contender> contenders;
    for (const int cell_edge : {2, 1})
      {
        for (const Preconditioner preconditioner :
             {Preconditioner::gmg, Preconditioner::ml, Preconditioner::muelu})
          contenders.push_back(
            magmpm_contender(preconditioner, cell_edge, MaterialIndicator::sharp, tolerance));
        contenders.push_back(
          magmpm_contender(Preconditioner::gmg, cell_edge, MaterialIndicator::smeared, tolerance));
      }
    // Neumann as in the paper; half of its 1 m box is 4.3 radii of a sphere as large as its cube.
    for (const double half_width : {3., 4.3, 6.})
      contenders.push_back(paper_contender(BoxFaces::shielded, half_width, tolerance));
    for (const double half_width : {2., 3.})
      contenders.push_back(paper_contender(BoxFaces::open, half_width, tolerance));
    return contenders;
  }

  /** What cubes are compared with: a fine run of magmpm with cells of edge dx. */
  struct Reference
  {
    Reference(const int resolution, const Medium &medium)
      : experiment(ExperimentKind::cube_near_magnet, resolution, 0, medium)
      , state(magmpm_contender(Preconditioner::gmg, 1, MaterialIndicator::sharp, 1e-8)
                .run(experiment)
                .state)
    {
    }

    Experiment experiment;
    MagneticState state;
  };

  int
  n_repetitions(const int resolution, const double most)
  {
    const double share = resolution <= 6 ? 1. : (resolution <= 12 ? 2. / 3. : 0.5);
    return std::max(1, static_cast<int>(std::lround(share * most)));
  }

  /**
   * All contenders take turns, each turn at another place. Those that took too long are left out of
   * what follows.
   */
  void
  measure(const ExperimentKind kind,
          const int resolution,
          const SpeedOptions &options,
          const std::optional<Reference> &reference,
          std::vector<Contender> &contenders,
          SpeedTable &table)
  {
    std::vector<Measurement> measurements;
    for (const Contender &contender : contenders)
      measurements.emplace_back(contender.scheme, contender.name, resolution);
    for (int n = 0; n < n_repetitions(resolution, options.repetitions); ++n)
      {
        const Experiment experiment(kind, resolution, n, options.medium);
        for (std::size_t c = 0; c < contenders.size(); ++c)
          if (resolution >= contenders[c].coarsest)
            {
              const Outcome outcome = contenders[c].run(experiment);
              measurements[c].add(
                outcome,
                reference
                  ? experiment.errors(outcome.state, reference->experiment, reference->state)
                  : experiment.errors(outcome.state));
            }
      }
    std::vector<Contender> affordable;
    for (std::size_t c = 0; c < contenders.size(); ++c)
      {
        if (measurements[c].n_runs > 0)
          table.add(measurements[c]);
        if (measurements[c].cold.seconds <= options.max_seconds)
          affordable.push_back(contenders[c]);
      }
    contenders = affordable;
  }

  void
  measure_all(const ExperimentKind kind, const SpeedOptions &options, SpeedTable &table)
  {
    std::vector<Contender> contenders = all_contenders(options.tolerance);
    std::optional<Reference> reference;
    if (kind == ExperimentKind::cube_near_magnet)
      reference.emplace(static_cast<int>(options.reference), options.medium);
    table.start_experiment(kind);
    for (const int resolution : resolutions)
      if (resolution <= options.max_resolution &&
          (!reference || resolution < reference->experiment.resolution))
        measure(kind, resolution, options, reference, contenders, table);
    table.finish_experiment();
  }

  void
  run_program(const SpeedOptions &options)
  {
    if (options.help)
      {
        std::cout << speed_usage();
        return;
      }
    std::cout
      << version_string() << "\nchi_0 = " << options.medium.susceptibility
      << ", a = " << options.medium.argument << ", Newton tolerance " << options.tolerance
      << ", one thread.\nErrors: rms over the runs; s: the best of them, of computing time; "
      << "ns/(u i): warm time per unknown and CG iteration" << std::endl;
    SpeedTable table(std::cout, options.csv_file);
    for (const ExperimentKind kind : options.experiments)
      measure_all(kind, options, table);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_WORLD, std::cerr, [&]() {
    run_program(parse_speed_options({argv + 1, argv + argc}));
  }));
}
