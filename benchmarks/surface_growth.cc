#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>

#include <deal.II/base/mpi.h>

#include <verification/mechanics/surface_growth.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  SurfaceWave
  wave(const double over_cutoff,
       const double steepness,
       const int cells,
       const int particles = 4,
       const double sound  = 40.)
  {
    SurfaceWave result;
    result.over_cutoff         = over_cutoff;
    result.steepness           = steepness;
    result.cells_per_half_wave = cells;
    result.particles_per_edge  = particles;
    result.sound_ratio         = sound;
    result.duration            = over_cutoff > 1. ? 1.2 : 1.5;
    return result;
  }

  void
  measure(const SurfaceWave &wave)
  {
    const auto start                            = std::chrono::steady_clock::now();
    const SurfaceGrowth growth                  = surface_growth(wave);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("| %4.2f | %2d | %2d | %.3f | %3.0f | %s %.2f | %s %.2f | %+.1f %% | %.2f | %.2f | "
                "%.3f | %.0f |\n",
                wave.over_cutoff,
                wave.cells_per_half_wave,
                wave.particles_per_edge * wave.particles_per_edge,
                wave.steepness,
                wave.sound_ratio,
                growth.exact_square > 0. ? "s =" : "omega =",
                std::sqrt(std::abs(growth.exact_square)),
                growth.measured_square > 0. ? "s =" : "omega =",
                std::sqrt(std::abs(growth.measured_square)),
                100. * growth.relative_error(),
                growth.final_amplitude,
                growth.exact_amplitude,
                growth.fit_error,
                seconds.count());
    std::fflush(stdout);
  }

  void
  run_program()
  {
    std::cout
      << version_string() << '\n'
      << "| k/k_c | cells per half wave | particles per cell | k a at t = 0 | c/sqrt(g/k) | "
         "exact [1/s] | measured [1/s] | error | a/a_0 at the end | exact | left by the fit "
         "| seconds |\n|---|---|---|---|---|---|---|---|---|---|---|---|"
      << std::endl;
    // Above the cut-off a wave grows, and all shorter ones faster: it must be watched before they show.
    for (const int cells : {16, 32})
      {
        for (const double over_cutoff : {2., 3., 4., 6.})
          measure(wave(over_cutoff, cells == 16 ? 0.1 : 0.05, cells));
        for (const double over_cutoff : {0., 0.25, 0.5})
          measure(wave(over_cutoff, 0.1, cells));
      }
    // What the figures depend on: particles, the height of the wave, the speed of sound.
    for (const int particles : {2, 3})
      measure(wave(4., 0.05, 32, particles));
    for (const double steepness : {0.07, 0.1})
      measure(wave(4., steepness, 32));
    measure(wave(4., 0.05, 32, 4, 20.));
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return static_cast<int>(parallel::report_errors(MPI_COMM_SELF, std::cerr, run_program));
}
