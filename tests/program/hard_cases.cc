// Cases that have broken codes of this kind: each either runs right or stops with a clear message.

#include "catch.h"
#include "program/parameter_text.h"

#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  /** Runs a scene to its end and returns what it wrote; particles only, unless told. */
  Statistics
  statistics_of(const ParameterText &scene,
                const std::string &name,
                const std::string &options = "")
  {
    const Outcome run = run_magmpm(write_scene(name, scene.text()) +
                                   " --set Output/Particles=false --set Output/Fields=false " +
                                   options);
    INFO(name << ": " << run.errors);
    REQUIRE(run.exit_code == 0);
    return Statistics("output-" + name);
  }

  double
  largest_change(const std::vector<double> &column)
  {
    double change = 0.;
    for (const double value : column)
      change = std::max(change, std::abs(value - column.front()));
    return change;
  }

  double
  largest(const std::vector<double> &column)
  {
    return *std::max_element(column.begin(), column.end());
  }

  /** Energy never rises above what it was at the start, by more than @p fraction of it. */
  void
  check_energy(const Statistics &statistics, const double fraction)
  {
    const std::vector<double> energy = mechanical_energy(statistics);
    INFO("energy rose by " << largest(energy) / energy.front() - 1.);
    CHECK(largest(energy) <= (1. + fraction) * energy.front());
  }
} // namespace

TEST_CASE("Bodies that meet merge and keep their momentum", "[program]")
{
  // Two drops and two soft blocks fly into one another in free space. The lattice has one velocity,
  // so they stick; momentum and angular momentum stay, the latter but for 1e-4 of FMPM, and energy falls. (It
  // rises by 2e-4 before they meet: the lattice sees the density near a corner of a drop a little wrong, and
  // J follows it.) The blocks differ in stiffness, so that they are given back different parts.
  ParameterText scene;
  scene.end_time = "0.05";
  scene.add_fluid("water", "2e4", "0.1").add_solid("jelly", "1e4").add_solid("rubber", "4e4");
  scene.add_box("left", "water", "0.08, 0.08", "0.14, 0.14", "set Velocity = 1, 0.1\n")
    .add_box("right", "water", "0.18, 0.09", "0.24, 0.15", "set Velocity = -1, 0.1\n")
    .add_box("west", "jelly", "0.08, 0.2", "0.14, 0.26", "set Velocity = 1, -0.1\n")
    .add_box("east", "rubber", "0.18, 0.21", "0.24, 0.27", "set Velocity = -1, -0.1\n");
  const Statistics statistics = statistics_of(scene, "merging");
  check_energy(statistics, 1e-3);
  const double momentum = 4. * 1000. * 0.06 * 0.06;
  CHECK(largest_change(statistics["momentum x [kg/s]"]) < 1e-12 * momentum);
  CHECK(largest_change(statistics["momentum y [kg/s]"]) < 1e-12 * momentum);
  CHECK(largest_change(statistics["angular momentum z [kg m/s]"]) < 1e-4 * momentum);
  CHECK(statistics.last("kinetic energy [J/m]") < 0.7 * statistics["kinetic energy [J/m]"].front());
}

TEST_CASE("A body that tears keeps what is conserved", "[program]")
{
  // A bar spins so fast that its middle cannot hold it: the ends fly off. No particle is lost and, with
  // APIC, the momenta stay to rounding. Kinetic energy leaves out the spin of the particles in their own C, dx^2/4
  // |C|^2/2 = 5e-5 Omega^2/2 per mass, which is 8.9 % of that of the bar: it may rise by so much.
  ParameterText scene;
  scene.end_time = "0.04";
  scene.add_solid("jelly", "5e2", "set Transfer = APIC\n")
    .add_box("bar", "jelly", "0.12, 0.15", "0.2, 0.17", "set Angular velocity = 80\n");
  const Statistics statistics = statistics_of(scene, "tearing");
  check_energy(statistics, 0.089);
  const std::vector<double> &spin = statistics["angular momentum z [kg m/s]"];
  CHECK(largest_change(spin) < 1e-12 * std::abs(spin.front()));
  CHECK(largest(statistics["max J [-]"]) > 3.);
  CHECK(statistics.last("lost particles") == 0.);
}

TEST_CASE("A jet that splashes into a spray stays stable", "[program]")
{
  // Water at half its wave speed hits a wall and flies apart into single particles, which the
  // limits of the time step must hold: J stays within bounds, and no particle gets faster than the
  // jet was by more than a little.
  ParameterText scene;
  scene.end_time = "0.15";
  scene.gravity  = "0, -9.81";
  scene.add_fluid("water", "1e5", "0.001")
    .add_box(
      "jet", "water", "0.13, 0.04", "0.19, 0.20", "set Velocity = 0.3, -5\nset Jitter = 1\n");
  scene.rest                  = "subsection Walls\nset Lower y = slip\nset Lower x = slip\n"
                                "set Upper x = slip\nset Upper y = slip\nend\n";
  const Statistics statistics = statistics_of(scene, "spray");
  check_energy(statistics, 1e-3);
  CHECK(largest(statistics["max |v| [m/s]"]) < 15.);
  CHECK(largest(statistics["max J [-]"]) < 5.);
  CHECK(statistics.last("lost particles") == 0.);
}

TEST_CASE("Single particles vibrate within bounds", "[program]")
{
  // One particle alone is an oscillator with a limit of its own, omega dt < 2 with omega^2 = 4 (2 mu
  // s^2 + d lambda)/(rho dx^2) for a solid stretched by s: it spins, so that it is stretched, and flies
  // through all places between nodes, with node masses down to nothing. At 0.4 dx/c, for an almost
  // incompressible solid and a fluid, it neither gains energy nor leaves its straight way.
  ParameterText scene;
  scene.end_time = "0.2";
  scene.add_fluid("water", "1e4", "0").add_solid("rubber", "1e4");
  scene.materials.back().second = "set Young's modulus = 1e4\nset Poisson ratio = 0.49\n";
  const std::string one = "set Particles per edge = 1\nset Jitter = 1\nset Angular velocity = 50\n";
  scene.add_box("drop", "water", "0.05, 0.05", "0.06, 0.06", one + "set Velocity = 0.7, 0.3\n")
    .add_box("grain", "rubber", "0.05, 0.15", "0.06, 0.16", one + "set Velocity = 0.9, 0.4\n");
  const Statistics statistics = statistics_of(scene, "single-particles");
  REQUIRE(statistics.last("particles") == 2.);
  check_energy(statistics, 0.02);
  CHECK(largest_change(statistics["momentum x [kg/s]"]) < 1e-12);
  CHECK(largest_change(statistics["angular momentum z [kg m/s]"]) < 1e-13);
  CHECK(largest(statistics["max J [-]"]) < 3.);
}

TEST_CASE("A sheet one cell thick falls and folds", "[program]")
{
  // A sheet of 16 x 1 cells falls on a solid sphere, over which it folds, and on the ground. It stays
  // whole enough to end at rest near the ground, with energy falling all the time.
  ParameterText scene;
  scene.end_time = "0.3";
  scene.gravity  = "0, -9.81";
  scene.add_solid("rubber", "2e4").add_box("sheet", "rubber", "0.08, 0.2", "0.24, 0.21");
  scene.rest                  = "subsection Magnets\nset List of magnets = ball\nsubsection ball\n"
                                "set Type = magnetized sphere\nset Position = 0.16; 0.05\nset Magnetization = 0; 0\n"
                                "set Radius = 0.05\nset Contact = slip\nend\nend\n";
  const Statistics statistics = statistics_of(scene, "thin-sheet");
  check_energy(statistics, 1e-12);
  CHECK(statistics.last("max J [-]") < 5.);
  CHECK(statistics.last("lost particles") == 0.);
  CHECK(statistics.last("centre of mass y [m]") < 0.15);
}

TEST_CASE("A fast magnet is driven through a block", "[program]")
{
  // A solid magnet crosses a magnetic block at 20 m/s, twice its wave speed, and tears it: its speed
  // limits the time step, no particle is left inside of it, and the run goes on to its end.
  ParameterText scene;
  scene.end_time = "0.012";
  scene.box = "0.64, 0.32"; // what is thrown off does not reach a wall, where it would be crushed
  scene
    .add_solid(
      "clay", "1e5", "set Saturation magnetization = 5e4\nset Initial susceptibility = 1\n")
    .add_box("block", "clay", "0.1, 0.1", "0.2, 0.2");
  scene.rest             = "subsection Magnets\nset List of magnets = bullet\nsubsection bullet\n"
                           "set Type = magnetized sphere\nset Position = 0.06 + 20*t; 0.15\n"
                           "set Magnetization = 1e5; 0\nset Radius = 0.03\nset Contact = separate\nend\nend\n";
  const std::string name = "fast-magnet";
  const Outcome run = run_magmpm(write_scene(name, scene.text()) + " --set Output/Fields=false");
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const Statistics statistics("output-" + name);
  CHECK(largest(statistics["max |v| [m/s]"]) > 15.);
  CHECK(largest(statistics["max |v| [m/s]"]) < 60.);
  for (std::size_t row = 1; row < statistics.n_rows(); ++row)
    CHECK(statistics["dt [s]"][row] <= (1. + 1e-9) * 0.4 * 0.01 / 20.);
  // The nodes inside of the magnet move with it; particles may be one cell deep in its surface.
  double deepest = 1.;
  for (const auto &position : particle_positions("output-" + name).back())
    deepest = std::min(deepest, std::hypot(position[0] - 0.06 - 20. * 0.012, position[1] - 0.15));
  CHECK(deepest > 0.03 - 0.01);
}

TEST_CASE("Material that fills the box stays at rest", "[program]")
{
  // Water and a solid from wall to wall, without gravity and with it: without it nothing moves at all,
  // with it the water settles into its hydrostatic pressure, energy falls, and nothing is lost.
  for (const std::string material : {"water", "rubber"})
    for (const std::string gravity : {"0, 0", "0, -9.81"})
      {
        ParameterText scene;
        scene.gravity = gravity;
        scene.box     = "0.16, 0.16";
        scene.add_fluid("water", "1e5", "1").add_solid("rubber", "1e5");
        scene.add_box("body", material, "0, 0", "0.16, 0.16");
        const Statistics statistics =
          statistics_of(scene, "filled-" + material + (gravity == "0, 0" ? "-0" : "-1"));
        if (gravity == "0, 0")
          CHECK(largest(statistics["max |v| [m/s]"]) < 0.05);
        else
          check_energy(statistics, 1e-4);
        CHECK(statistics.last("lost particles") == 0.);
        CHECK(largest_change(statistics["max J [-]"]) < 0.05);
      }
}

TEST_CASE("A body that is crushed ends the run before it turns inside out", "[program]")
{
  // A soft block hits a wall at 15 times its wave speed. Its particles are squeezed beyond the limit
  // of J: the run ends in the step in which the first one passes it, names it with its place, its
  // velocity and the limit of the time step, and leaves no row of statistics with what went wrong.
  ParameterText scene;
  scene.add_solid("jelly", "1e3")
    .add_box("block", "jelly", "0.12, 0.02", "0.18, 0.08", "set Velocity = 0, -15\n");
  const Outcome run =
    run_magmpm(write_scene("crushed", scene.text()) + " --set \"Output/Frame interval=0.001\"");
  INFO(run.errors);
  CHECK(run.exit_code == 1);
  for (const std::string part : {"of body 'block' ran away at t = ",
                                 "limit: ",
                                 "J = ",
                                 "velocity (",
                                 "position (",
                                 "The last frame written is good"})
    CHECK(run.errors.find(part) != std::string::npos);
  const Statistics statistics("output-crushed");
  for (std::size_t row = 0; row < statistics.n_rows(); ++row)
    CHECK(statistics["min J [-]"][row] >= 0.05);
  CHECK(particle_positions("output-crushed").size() > 1);
}
