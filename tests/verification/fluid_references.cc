#include "catch.h"

#include <magmpm/base/constants.h>

#include <verification/mechanics/archimedes.h>
#include <verification/mechanics/inviscid_collapse.h>
#include <verification/mechanics/standing_wave.h>

#include <cmath>
#include <cstddef>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double pi = constants::pi;

  /** How far the centre of a body of this density is above the surface, of its half size; the pool is stiff and wide. */
  double
  height_above_surface(const int dim,
                       const bool is_round,
                       const double density,
                       const double turn = 0.)
  {
    const Pool pool       = {dim, 1e3, 2., 1000., 1e13, 9.81};
    const Floater floater = {is_round, 0.5, 1000. * density, turn};
    const double rise     = density * floater.volume(dim) / std::pow(pool.width, dim - 1);
    return (floating_height(pool, floater) - pool.depth - rise) / floater.half_size;
  }
} // namespace

TEST_CASE("Bodies float as deep as Archimedes says", "[verification]")
{
  // Half of the density is half of the volume. At a quarter, the segment of a disc has acos x - x sqrt(1 - x^2) =
  // pi/4, the cap of a ball (2 - 3 x + x^3)/4 = 1/4, and a box is immersed by a quarter of its edge.
  for (const int dim : {2, 3})
    for (const bool is_round : {true, false})
      {
        INFO(dim << "D, " << (is_round ? "round" : "box"));
        CHECK(height_above_surface(dim, is_round, 0.5) == Approx(0.).margin(1e-4));
        CHECK(height_above_surface(dim, is_round, 0.25) ==
              Approx(-height_above_surface(dim, is_round, 0.75)).epsilon(1e-3));
      }
  CHECK(height_above_surface(2, true, 0.25) == Approx(0.40397).epsilon(1e-3));
  CHECK(height_above_surface(3, true, 0.25) == Approx(2. * std::cos(4. * pi / 9.)).epsilon(1e-3));
  CHECK(height_above_surface(2, false, 0.25) == Approx(0.5).epsilon(1e-3));
  // On its corner a square is immersed by a triangle, of its half edge's height; turned by a little it stays as deep
  // in the middle.
  for (const int dim : {2, 3})
    {
      CHECK(height_above_surface(dim, false, 0.25, 0.25 * pi) ==
            Approx(std::sqrt(2.) - 1.).epsilon(1e-3));
      CHECK(height_above_surface(dim, false, 0.25, 0.1) ==
            Approx(0.5 * std::cos(0.1)).epsilon(1e-3));
    }
}

TEST_CASE("A pool at rest is compressed by its own weight", "[verification]")
{
  // At the floor J = 1 - rho g H/K. A box of half the density weighs as much as 0.01 m more of the fluid, and is
  // immersed less in fluid that is denser by the pressure at half its depth over K.
  const Pool pool = {2, 0.32, 0.12, 1000., 5e4, 9.81};
  CHECK(pool.density_at(pool.level()) ==
        Approx(1000. / (1. - 1000. * 9.81 * 0.12 / 5e4)).epsilon(1e-12));
  Pool stiff = pool, fuller = pool;
  stiff.bulk_modulus         = 1e13;
  fuller.depth               = 0.13;
  const Floater box          = {false, 0.04, 500., 0.};
  const double less_immersed = 0.04 * (1000. * 9.81 * 0.02 / 5e4);
  CHECK(floating_height(pool, box) - floating_height(stiff, box) ==
        Approx(fuller.level() - fuller.depth + less_immersed).margin(5e-6));
}

TEST_CASE("The frequency of a standing wave has its limits", "[verification]")
{
  // Without compression sqrt(g k tanh(k d)); deep water sqrt(g k), whatever the speed of sound; there a high wave
  // is slower by (k a)^2/8, and at k d = 1.058 its height does not matter.
  WaveTank tank;
  const double k = pi / tank.width;
  tank.sound     = 1e5;
  CHECK(standing_wave_frequency(tank) ==
        Approx(std::sqrt(9.81 * k * std::tanh(k * tank.depth))).epsilon(1e-8));
  tank.depth = 5.;
  tank.sound = 10.;
  CHECK(standing_wave_frequency(tank) == Approx(std::sqrt(9.81 * k)).epsilon(1e-8));
  CHECK(standing_wave_frequency(tank, 0.1) / standing_wave_frequency(tank) ==
        Approx(1. - 0.125 * std::pow(0.1 * k, 2)).epsilon(1e-6));
  tank.depth = 1.058 / k;
  CHECK(std::abs(standing_wave_frequency(tank, 0.1) / standing_wave_frequency(tank) - 1.) < 1e-4);
  // A soft fluid swings more slowly, by about the square of the Mach number.
  tank             = WaveTank();
  const double now = standing_wave_frequency(tank);
  tank.sound       = 1e5;
  CHECK(now < standing_wave_frequency(tank));
  CHECK(now > 0.995 * standing_wave_frequency(tank));
}

TEST_CASE("Boundary elements follow a collapsing column", "[verification]")
{
  // Fronts of another program of boundary elements, by quadrature on 120 nodes, in second order in time. The volume
  // stays.
  const std::vector<double> times         = {0.832, 1.219, 1.997, 2.547, 3.345, 4.034};
  const std::vector<double> places        = {1.260, 1.616, 2.504, 3.244, 4.458, 5.595};
  const std::vector<InviscidFront> fronts = inviscid_fronts(times, 60);
  REQUIRE(fronts.size() == times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    {
      CHECK(fronts[i].time == times[i]);
      CHECK(fronts[i].front == Approx(places[i]).epsilon(2e-3));
      CHECK(std::abs(fronts[i].area) < 2e-3);
    }
}
