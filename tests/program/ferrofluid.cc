#include "catch.h"

#include <verification/mechanics/surface_growth.h>
#include <verification/mechanics/wire_meniscus.h>

#include <cmath>

using namespace magmpm::verification;

// Waves on a layer of ferrofluid in a vertical field, coarse cases of benchmarks/surface_growth;
// doc/verification.md has the table.

TEST_CASE("A magnetized surface grows as fast as Cowley and Rosensweig say", "[program]")
{
  // Twice and four times the cut-off: s within 15 %, from a standing start, a/a_0 = cosh(1.2) = 1.8
  // at the end; k a stays under 0.3.
  for (const double over_cutoff : {2., 4.})
    {
      SurfaceWave wave;
      wave.over_cutoff           = over_cutoff;
      wave.cells_per_half_wave   = 16;
      const SurfaceGrowth growth = surface_growth(wave);
      INFO("k/k_c = " << over_cutoff << ": error " << growth.relative_error() << ", a/a_0 "
                      << growth.final_amplitude << ", left by the fit " << growth.fit_error);
      CHECK(growth.measured_square > 0.);
      CHECK(std::abs(growth.relative_error()) < 0.15);
      CHECK(growth.final_amplitude > 1.5);
      CHECK(growth.final_steepness < 0.3);
      CHECK(growth.fit_error < 0.05);
    }
}

TEST_CASE("A magnetized surface swings below the cut-off and without field", "[program]")
{
  // The same wave in half the field of the cut-off (k_c/4), and in none, the negative control: it
  // falls, with the frequency of the same formula within 12 %; the field takes 13 % of it.
  double omega[2];
  for (const int i : {0, 1})
    {
      SurfaceWave wave;
      wave.over_cutoff           = i == 0 ? 0. : 0.25;
      wave.cells_per_half_wave   = 16;
      wave.duration              = 1.5;
      const SurfaceGrowth growth = surface_growth(wave);
      INFO("k/k_c = " << wave.over_cutoff << ": error " << growth.relative_error() << ", a/a_0 "
                      << growth.final_amplitude);
      CHECK(growth.measured_square < 0.);
      CHECK(std::abs(growth.relative_error()) < 0.12);
      CHECK(growth.final_amplitude < 0.35);
      omega[i] = std::sqrt(-growth.measured_square);
    }
  CHECK(omega[1] < 0.92 * omega[0]);
}

TEST_CASE("Ferrofluid stands higher round a wire with a current", "[program]")
{
  // The conical meniscus: heights differ by mu_0 int M dH/(rho g), here on 16^2 cells to 8 %. Without current the pool
  // stays flat.
  WireMeniscus pool;
  pool.cells                    = 16;
  const MeniscusHeights heights = meniscus_heights(pool);
  INFO("height " << heights.measured << ", exact " << heights.exact);
  CHECK(heights.exact > 0.05);
  CHECK(std::abs(heights.measured / heights.exact - 1.) < 0.08);
  pool.current = 0.;
  CHECK(std::abs(meniscus_heights(pool).measured) < 0.02 * heights.exact);
}
