#include <magmpm/base/exceptions.h>
#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>
#include <magmpm/parallel/ranks.h>

#include <deal.II/base/mpi.h>

#include <magnetic_accuracy/accuracy_table.h>
#include <magnetic_accuracy/case_list.h>
#include <magnetic_accuracy/options.h>

#include <algorithm>
#include <iostream>

using namespace magmpm;
using namespace magmpm::benchmarks;
using namespace magmpm::verification;

template <int dim>
static void
measure_all(const Options &options, AccuracyTable &table)
{
  AccuracyCase standard;
  standard.indicator = options.indicator;
  standard.cell_edge = options.cell_edge;
  for (const CaseSeries &series : all_cases<dim>(standard))
    if (options.wants(series.group))
      {
        for (const auto &resolution : series.resolutions)
          if (resolution.value <= options.max_resolution)
            {
              AccuracyCase accuracy_case = series.accuracy_case;
              accuracy_case.resolution   = resolution.value;
              std::vector<Errors> offsets;
              for (unsigned int n = 0; n < std::min(resolution.n_offsets, options.max_offsets); ++n)
                {
                  accuracy_case.offset = n;
                  offsets.push_back(series.measure(accuracy_case));
                }
              table.add({dim, series.group, series.variant, resolution.value}, offsets);
            }
        if (series.fits_orders)
          table.add_orders();
        table.end_series();
      }
}

static void
run_program(const Options &options, std::ostream &terminal)
{
  if (options.help)
    {
      terminal << usage(case_groups());
      return;
    }
  if (!options.csv)
    terminal << version_string() << ", " << parallel::n_ranks(MPI_COMM_WORLD) << " ranks"
             << std::endl
             << "Relative errors of the magnetic part; "
             << (options.indicator == MaterialIndicator::sharp ? "sharp" : "smeared")
             << " indicator, cells of " << options.cell_edge << " dx at material" << std::endl;
  AccuracyTable table(terminal, options.csv);
  for (const int dim : options.dimensions)
    if (dim == 2)
      measure_all<2>(options, table);
    else
      measure_all<3>(options, table);

  const std::string verdict = std::to_string(table.n_missed()) + " limits missed";
  if (!options.csv)
    terminal << std::endl << verdict << std::endl;
  if (options.check && table.n_missed() > 0)
    throw RunError(verdict + ".");
}

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // Of all ranks only the first is heard.
  std::ostream silence(nullptr);
  const bool first       = parallel::rank(MPI_COMM_WORLD) == 0;
  std::ostream &terminal = first ? std::cout : silence;
  return static_cast<int>(parallel::report_errors(MPI_COMM_WORLD, std::cerr, [&]() {
    run_program(parse_options({argv + 1, argv + argc}, case_groups()), terminal);
  }));
}
