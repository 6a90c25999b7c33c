// Scenes in which fluid carries something, or itself over something: the files of parameter_files/
// on coarser lattices, and again without their magnets.

#include "catch.h"
#include "program/parameter_file_run.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cstdio>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  Statistics
  statistics_of(const std::string &scene, const std::string &name, const std::string &options)
  {
    const Outcome run = run_parameter_file(scene,
                                           "output-" + name,
                                           "--set Output/Particles=false"
                                           " --set 'Output/Frame interval=0.05' " +
                                             options);
    INFO(name << ": " << run.errors);
    REQUIRE(run.exit_code == 0);
    return Statistics("output-" + name);
  }

  const std::string no_magnets = " --set 'Magnets/List of magnets='";
} // namespace

TEST_CASE("A lump crawls over magnetic balls, and only falls without them", "[program]")
{
  // The lump starts beside the first of the balls, which lie along x; the other one falls straight
  // down. Both have the same mass, so the centre of mass goes half as far along x as the lump.
  // Without magnets it collapses where it is, evenly to both sides.
  const std::string coarse = " --set 'Box/Cell size=0.03125' --set 'End time=0.1'";
  const auto crawled       = [&](const std::string &name, const std::string &options) {
    const Statistics statistics = statistics_of("buckyballs", name, coarse + options);
    const auto &x               = statistics["centre of mass x [m]"];
    return 2. * (x.back() - x.front());
  };
  const double with = crawled("balls", ""), without = crawled("no-balls", no_magnets);
  std::printf(
    "lump after 0.1 s: crawled %.1f mm, without balls %.2g mm\n", 1e3 * with, 1e3 * without);
  CHECK(with > 0.015);
  CHECK(std::abs(without) < 0.002);
}

TEST_CASE("The surfer is carried at the speed of the fluid", "[program]")
{
  // The magnet under the ground draws the fluid along x, and the board sticks to the fluid: in the
  // end the surfer is about as fast as the fluid on the mean, and has gone about as far, upright.
  // Without magnet neither moves.
  const std::string coarse = " --set 'Box/Cell size=0.015625' --set 'End time=0.2'"
                             " --set 'Bodies/wave/Particles per edge=2'"
                             " --set 'Bodies/wave/Arrangement=cubic'";
  struct Ride
  {
    double way, way_of_fluid, speed, speed_of_fluid, tilt;
  };
  const auto ride = [&](const std::string &name, const std::string &options) {
    const Statistics statistics = statistics_of("surfing", name, coarse + options);
    const auto &x               = statistics["centre of mass x [m]"];
    const auto &surfer          = statistics["surfer: position x [m]"];
    const auto &time            = statistics["time [s]"];
    const std::size_t half      = x.size() / 2;
    const double rest           = time.back() - time[half];
    return Ride{surfer.back() - surfer.front(),
                x.back() - x.front(),
                (surfer.back() - surfer[half]) / rest,
                (x.back() - x[half]) / rest,
                std::max(std::abs(statistics.last("surfer: rotation x [rad]")),
                         std::abs(statistics.last("surfer: rotation y [rad]")))};
  };
  const Ride with = ride("surfing", ""), without = ride("no-surfing", no_magnets);
  std::printf(
    "surfer after 0.2 s: %.0f mm, fluid %.0f mm; lately %.2f and %.2f m/s, tilted by %.2f; "
    "without magnet %.2g mm\n",
    1e3 * with.way,
    1e3 * with.way_of_fluid,
    with.speed,
    with.speed_of_fluid,
    with.tilt,
    1e3 * without.way);
  CHECK(with.way > 0.05);
  CHECK(with.speed == Approx(with.speed_of_fluid).epsilon(0.25));
  CHECK(with.tilt < 0.5);
  CHECK(std::abs(without.way) < 0.01);
}
