// Fluids that start compressed by their weight.

#include "catch.h"
#include "program/equal_runs.h"
#include "program/parameter_text.h"

#include <verification/mechanics/hydrostatic_start.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <fstream>
#include <string>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  /** Oil on water, in a column beside a wall that is about to collapse. */
  ParameterText
  layered_column(const std::string &bulk_modulus)
  {
    const std::string hydrostatic = "set Initial state = hydrostatic\n";
    ParameterText scene;
    scene.end_time = "0.02";
    scene.gravity  = "0, -9.81";
    scene.add_fluid("water", bulk_modulus, "0.01")
      .add_fluid("oil", "2e4", "0.01")
      .add_box("deep", "water", "0, 0", "0.1, 0.08", hydrostatic)
      .add_body("top",
                "oil",
                "800",
                hydrostatic + "set Lower corner = 0, 0.08\nset Upper corner = 0.1, 0.17\n");
    scene.rest = walls(2, "slip") + "subsection Output\nset Particles = false\n"
                                    "set Frame interval = 0.01\nend\n";
    return scene;
  }
} // namespace

TEST_CASE("A pool that starts hydrostatic is at rest", "[program]")
{
  // Nothing is to move: the pressure is that of the weight from the first step on. What is left, less than 1e-4 of the
  // speed of sound, is what the lattice sees differently at the surface; undeformed water sinks, at 3e-2.
  for (const std::string wall : {"slip", "separate"})
    CHECK(hydrostatic_unrest({2, 16, 0.05, wall}) < 1e-4);
  CHECK(hydrostatic_unrest({3, 16, 0.05}) < 1e-4);
}

TEST_CASE("Oil that starts hydrostatic on water is at rest", "[program]")
{
  // As above, with another density and modulus in the upper half: water bears oil as well.
  CHECK(hydrostatic_unrest({2, 16, 0.05, "slip", true}) < 1e-4);
}

TEST_CASE("A hydrostatic start is the same on any number of ranks", "[program]")
{
  // The weight above a particle is found from the shapes, whoever has the particles of the column.
  const Statistics one(run_scene("layered-1", layered_column("4e4").text()));
  for (const int n_ranks : {2, 4})
    {
      const std::string name = "layered-" + std::to_string(n_ranks);
      REQUIRE(run_magmpm(write_scene(name, layered_column("4e4").text()), n_ranks).exit_code == 0);
      check_equal_runs(one, Statistics("output-" + name), 1e-9, depends_on_ranks);
    }
  // The log tells what was seeded: water that bears 719.3 Pa above and 1526.7 Pa below weighs, per metre,
  // 0.1 (1526.7 - 719.3)/9.81 kg.
  CHECK(
    contents("output-layered-4/log.txt").find("deep, seeded                 0.008         8.231") !=
    std::string::npos);
}

TEST_CASE("A fluid that its weight would crush is refused", "[program]")
{
  // The water bears 719 Pa of oil and up to 785 Pa of its own, of which its lowest particles, dx/4 above the
  // floor, bear all but 25 Pa: 1480 Pa in all. What the message asks for will do.
  const Outcome run = run_magmpm(write_scene("crushed", layered_column("1500").text()), 2);
  CHECK(run.exit_code == 2);
  CHECK(
    run.errors.find(
      "body 'deep' with Initial state = hydrostatic is compressed to J = 0 by the weight of what "
      "stands above, 1479.53 Pa; J may be 0.5 to 1. Set 'Bulk modulus' of its material to at least "
      "4438.58 Pa.") != std::string::npos);
  CHECK(run_magmpm(write_scene("pressed", layered_column("4438.58").text())).exit_code == 0);
}

TEST_CASE("Points cannot start hydrostatic", "[program]")
{
  // Of a list of points it is not known where the fluid ends.
  std::ofstream("drops.csv") << "0.1, 0.1\n0.12, 0.1\n";
  ParameterText scene;
  scene.gravity = "0, -9.81";
  scene.add_fluid("water", "1e5", "0.01")
    .add_body("drops",
              "water",
              "1000",
              "set Shape = points\nset File = drops.csv\nset Initial state = hydrostatic\n");
  const Outcome run = run_magmpm(write_scene("drops", scene.text()));
  CHECK(run.exit_code == 2);
  CHECK(run.errors.find(
          "Bodies/drops/Initial state = hydrostatic: with Shape = points it is not known "
          "what stands above a particle. Set it to undeformed, or choose another shape.") !=
        std::string::npos);
}
