// Gravity that changes in time.

#include "catch.h"
#include "program/equal_runs.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  constexpr double lean = 3., down = 9.81, rate = 40.; // m/s^2, 1/s

  /** A block of fluid and a rigid one, which touch nothing, in gravity that turns. */
  std::string
  scene()
  {
    ParameterText scene;
    scene.end_time = "0.06";
    scene.gravity  = "3*sin(40*t); -9.81*cos(40*t)";
    scene.add_fluid("water", "1e5", "0.01").add_box("block", "water", "0.06, 0.12", "0.1, 0.16");
    scene.rest = "subsection Rigid bodies\nset List of rigid bodies = raft\nsubsection raft\n"
                 "set Lower corner = 0.2, 0.12\nset Upper corner = 0.24, 0.16\nset Density = 500\n"
                 "end\nend\nsubsection Output\nset Particles = false\nset Rigid bodies = false\n"
                 "set Frame interval = 0.02\nend\n";
    return scene.text();
  }
} // namespace

TEST_CASE("Gravity may change in time", "[program]")
{
  // Without contact momentum is that which gravity has given until now, the sum of m g(t) dt with g of the start
  // of each step, of material and of rigid bodies; the energy in gravity is that of g now.
  const Statistics statistics(run_scene("turning-gravity", scene()));
  constexpr double mass = 1000. * 0.04 * 0.04;
  double along = 0., upward = 0., error = 0., energy = 0.;
  for (std::size_t row = 0; row < statistics.n_rows(); ++row)
    {
      const double now = statistics["time [s]"][row], dt = statistics["dt [s]"][row];
      along += dt * lean * std::sin(rate * (now - dt));
      upward -= dt * down * std::cos(rate * (now - dt));
      error = std::max({error,
                        std::abs(statistics["momentum x [kg/s]"][row] / mass - along),
                        std::abs(statistics["momentum y [kg/s]"][row] / mass - upward),
                        std::abs(statistics["raft: velocity x [m/s]"][row] - along),
                        std::abs(statistics["raft: velocity y [m/s]"][row] - upward)});
      const double potential =
        -lean * std::sin(rate * now) * statistics["centre of mass x [m]"][row] +
        down * std::cos(rate * now) * statistics["centre of mass y [m]"][row];
      energy = std::max(energy,
                        std::abs(statistics["gravitational energy [J/m]"][row] - mass * potential));
    }
  CHECK(error < 1e-12);
  CHECK(energy < 1e-12 * mass);
  CHECK(std::abs(along) > 0.05);
}

TEST_CASE("A run in gravity that changes is the same on two ranks and when resumed", "[program]")
{
  // The step takes gravity at its own time, which ranks share and a checkpoint keeps. What falls freely has no elastic
  // energy but by rounding.
  const auto ignores = [](const std::string &heading) {
    return depends_on_ranks(heading) || heading == "elastic energy [J/m]";
  };
  const Statistics straight(run_scene("turning-1", scene()));
  REQUIRE(run_magmpm(write_scene("turning-2", scene()), 2).exit_code == 0);
  check_equal_runs(straight, Statistics("output-turning-2"), 1e-9, ignores);

  const std::string file = write_scene("turning-resumed", scene());
  REQUIRE(run_magmpm(file + " --set \"End time=0.02\"").exit_code == 0);
  REQUIRE(run_magmpm("--resume " + file).exit_code == 0);
  check_equal_runs(straight, Statistics("output-turning-resumed"), 1e-12, ignores);
}
