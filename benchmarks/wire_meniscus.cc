#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <verification/mechanics/wire_meniscus.h>

#include <chrono>
#include <cstdio>
#include <iostream>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  void
  measure(const WireMeniscus &pool)
  {
    const auto start                            = std::chrono::steady_clock::now();
    const MeniscusHeights heights               = meniscus_heights(pool);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("| %4.0f | %2d | %.4f | %.4f | %+.1f %% | %.1e | %.0f |\n",
                pool.current,
                pool.cells,
                heights.measured,
                heights.exact,
                heights.exact > 0. ? 100. * (heights.measured / heights.exact - 1.) : 0.,
                heights.speed,
                seconds.count());
    std::fflush(stdout);
  }

  void
  run_program()
  {
    std::cout
      << version_string()
      << "\nheight of the inner ring over the outer one, over the edge of the pool\n"
         "| current [A] | cells along the edge | measured | exact | error | rms speed [m/s] | "
         "seconds |\n|---|---|---|---|---|---|---|"
      << std::endl;
    WireMeniscus pool;
    for (const int cells : {16, 32})
      {
        pool.cells = cells;
        measure(pool);
      }
    pool.cells   = 16;
    pool.current = 0.;
    measure(pool);
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_SELF, std::cerr, run_program));
}
