// What many steps do to a fluid.

#include "catch.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

TEST_CASE("Shaken water keeps its volume", "[program]")
{
  // A tank half full of water, in gravity that leans over, for 1e4 steps: waves, splashes, and what the
  // lattice does not resolve mixes the particles. Without relaxation particles crowd, and the centre of mass
  // sinks from 0.08 to 0.071 m; so the mean error of the claimed fraction must stay under 1 %, the height within
  // the swing of the waves, and J of all particles near the 0.95 of the floor and the 1 of the surface.
  ParameterText scene;
  scene.end_time = "7";
  scene.gravity  = "3, -9.81";
  scene.box      = "0.32, 0.32";
  scene.add_fluid("water", "3.2e4", "0.001").add_box("water", "water", "0, 0", "0.32, 0.16");
  scene.rest = "subsection Walls\nset Lower x = slip\nset Upper x = slip\nset Lower y = slip\n"
               "set Upper y = slip\nend\nsubsection Output\nset Frame interval = 0.5\n"
               "set Particles = false\nset Statistics every = 50\nend\n";
  const Outcome run = run_magmpm(write_scene("shaken", scene.text()));
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const Statistics statistics("output-shaken");
  REQUIRE(statistics.last("step") > 1e4);
  double error = 0., height = 0., volume = 0.;
  const std::size_t n = statistics.n_rows();
  for (std::size_t row = n / 2; row < n; ++row)
    {
      error += 2. * statistics["density error [-]"][row] / n;
      height += 2. * statistics["centre of mass y [m]"][row] / n;
      volume = std::max(volume, statistics["max J [-]"][row]);
    }
  INFO("mean |psi - 1| " << error << ", mean height " << height << ", J to " << volume);
  CHECK(error < 0.01);
  CHECK(error > 1e-4);
  CHECK(height > 0.075);
  CHECK(height < 0.095);
  CHECK(volume < 1.1);
  CHECK(statistics.last("lost particles") == 0.);
}
