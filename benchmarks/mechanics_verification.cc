#include <magmpm/base/exceptions.h>
#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <verification/mechanics/channel_flow.h>
#include <verification/mechanics/dam_break.h>
#include <verification/mechanics/elastic_bar.h>
#include <verification/mechanics/hydrostatic_column.h>
#include <verification/mechanics/spinning_block.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** A scene with an exact solution (or a measured one), on several lattices. */
  struct Case
  {
    std::string name;
    std::string quantity;
    std::vector<int> cells;
    double limit; ///< on the finest lattice
    std::function<double(int)> error;
  };

  double
  error_of_dam_break(const int cells)
  {
    const auto fronts = dam_fronts(cells);
    for (const DamFront &front : fronts)
      std::cout << "    T = " << front.time << ": Z = " << front.simulated << " (foremost particle "
                << front.foremost << "), without viscosity " << front.inviscid << ", measured "
                << front.measured << '\n';
    return dam_front_error(fronts);
  }

  double
  error_of_column(const int cells)
  {
    const HydrostaticErrors errors = hydrostatic_errors(cells);
    std::cout << "    in the cell at the floor: " << errors.floor_cell << '\n';
    return errors.inside;
  }

  const std::vector<Case> cases = {
    {"bar", "frequency sqrt(E/rho)/(4 L)", {16, 32, 64}, 0.02, frequency_error},
    {"column",
     "pressure rho g z above the lowest cell, of rho g H",
     {8, 16, 32},
     0.005,
     error_of_column},
    {"dam", "front against Martin & Moyce 1952", {8, 16, 32}, 0.1, error_of_dam_break},
    {"couette",
     "velocity U y/H, of U",
     {8, 16, 32},
     0.03,
     [](const int cells) { return velocity_error(ChannelFlow::couette, cells); }},
    {"poiseuille",
     "velocity g y (H - y)/(2 nu), of its largest",
     {8, 16, 32},
     0.03,
     [](const int cells) { return velocity_error(ChannelFlow::poiseuille, cells); }},
    {"spin", "angular momentum of a free block, APIC", {4, 8}, 1e-10, angular_momentum_error}};

  /** @return whether the finest lattice keeps the limit. */
  bool
  measure(const Case &a_case)
  {
    std::cout << a_case.name << ": " << a_case.quantity << std::endl;
    double error = 0.;
    for (const int cells : a_case.cells)
      {
        const auto start                            = std::chrono::steady_clock::now();
        error                                       = a_case.error(cells);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::cout << "  " << std::setw(3) << cells << " cells: error " << std::scientific
                  << std::setprecision(2) << error << std::defaultfloat << std::setprecision(4)
                  << "  (" << seconds.count() << " s)" << std::endl;
      }
    const bool kept = std::abs(error) <= a_case.limit;
    std::cout << "  limit " << a_case.limit << (kept ? ": kept" : ": MISSED") << std::endl;
    return kept;
  }

  void
  run_program(const std::vector<std::string> &wanted)
  {
    std::string names;
    for (const Case &a_case : cases)
      names += (names.empty() ? "" : ", ") + a_case.name;
    for (const std::string &name : wanted)
      if (std::none_of(cases.begin(), cases.end(), [&name](const Case &a_case) {
            return a_case.name == name;
          }))
        throw InputError("'" + name + "' is no case. There are: " + names +
                         "; without an argument all are run.");

    std::cout << version_string() << std::endl;
    int n_missed = 0;
    for (const Case &a_case : cases)
      if (wanted.empty() || std::find(wanted.begin(), wanted.end(), a_case.name) != wanted.end())
        n_missed += !measure(a_case);
    std::cout << n_missed << " limits missed" << std::endl;
    if (n_missed > 0)
      throw RunError(std::to_string(n_missed) + " limits missed.");
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_SELF, std::cerr, [&]() {
    run_program({argv + 1, argv + argc});
  }));
}
