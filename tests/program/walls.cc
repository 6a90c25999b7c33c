// Walls and open faces: nothing passes the ones, and what passes the others is told and counted.

#include "catch.h"
#include "program/parameter_text.h"

#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <algorithm>
#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  constexpr double cell_size = 0.01; // m, of all scenes here

  /** How far a particle lies beyond the box from 0 to @p edge in any frame [m]; not negative. */
  double
  furthest_beyond(const std::string &folder, const int dim, const double edge)
  {
    double beyond = 0.;
    for (const auto &frame : particle_positions(folder))
      for (const auto &position : frame)
        for (int d = 0; d < dim; ++d)
          beyond = std::max({beyond, -position[d], position[d] - edge});
    return beyond;
  }

  /** A solid and a fluid, which stream to the faces and corners that @p velocities point to. */
  ParameterText
  streams(const std::vector<std::pair<std::string, std::string>> &places_and_velocities)
  {
    ParameterText scene;
    scene.add_solid("rubber", "1e5").add_fluid("water", "1e5", "0.01");
    for (const auto &[corners, velocity] : places_and_velocities)
      {
        const std::string name  = "body" + std::to_string(scene.bodies.size());
        const std::size_t slash = corners.find('/');
        scene.add_box(name,
                      scene.bodies.size() % 2 == 0 ? "water" : "rubber",
                      corners.substr(0, slash),
                      corners.substr(slash + 1),
                      "set Velocity = " + velocity + "\n");
      }
    return scene;
  }

  /**
   * Every particle is inside in every frame, of solids to half a cell, and none is lost.
   *
   * @return how often walls held one.
   */
  double
  check_held(const ParameterText &scene, const std::string &name, const double edge)
  {
    const Outcome run =
      run_magmpm(write_scene(name, scene.text()) +
                 " --set \"Output/Frame interval=0.002\" --set Output/Fields=false");
    INFO(name << ": " << run.errors);
    REQUIRE(run.exit_code == 0);
    const std::string folder = "output-" + name;
    // Frames hold single precision.
    CHECK(furthest_beyond(folder, scene.dim, edge) <= 0.5 * cell_size + 1e-7 * edge);
    const Statistics statistics(folder);
    CHECK(statistics.last("lost particles") == 0.);
    CHECK(statistics.last("particles") == statistics["particles"].front());
    return statistics.last("held particles");
  }
} // namespace

TEST_CASE("Walls hold jets and bodies that are thrown at them", "[program]")
{
  // Half of them fluid, at up to 0.6 of the wave speed, at the four faces and into the four corners. Particles of
  // fluids never reach a wall: their images come from the other side as fast.
  for (const std::string condition : {"stick", "slip", "separate"})
    {
      ParameterText scene = streams({{"0.02, 0.13/0.08, 0.19", "-6, 0"},
                                     {"0.24, 0.13/0.30, 0.19", "6, 0"},
                                     {"0.13, 0.02/0.19, 0.08", "0, -6"},
                                     {"0.13, 0.24/0.19, 0.30", "0, 6"},
                                     {"0.02, 0.02/0.08, 0.08", "-2, -2"},
                                     {"0.24, 0.02/0.30, 0.08", "2, -2"},
                                     {"0.02, 0.24/0.08, 0.30", "-3, 3"},
                                     {"0.24, 0.24/0.30, 0.30", "3, 3"}});
      scene.end_time      = "0.04";
      scene.rest          = walls(2, condition);
      CHECK(check_held(scene, "thrown-" + condition, 0.32) == 0.);
    }
}

TEST_CASE("Walls hold in three dimensions", "[program]")
{
  // A body to each face and one into a corner, with each condition.
  for (const std::string condition : {"stick", "slip", "separate"})
    {
      ParameterText scene = streams({{"0.01, 0.06, 0.06/0.04, 0.09, 0.09", "-4, 0, 0"},
                                     {"0.12, 0.06, 0.06/0.15, 0.09, 0.09", "4, 0, 0"},
                                     {"0.06, 0.01, 0.06/0.09, 0.04, 0.09", "0, -4, 0"},
                                     {"0.06, 0.12, 0.06/0.09, 0.15, 0.09", "0, 4, 0"},
                                     {"0.06, 0.06, 0.01/0.09, 0.09, 0.04", "0, 0, -4"},
                                     {"0.06, 0.06, 0.12/0.09, 0.09, 0.15", "0, 0, 4"},
                                     {"0.12, 0.12, 0.12/0.15, 0.15, 0.15", "2, 2, 2"}});
      scene.dim           = 3;
      scene.gravity       = "0, 0, 0";
      scene.box           = "0.16, 0.16, 0.16";
      scene.end_time      = "0.015";
      scene.rest          = walls(3, condition);
      CHECK(check_held(scene, "boxed-" + condition, 0.16) == 0.);
    }
}

TEST_CASE("A wall takes the momentum that goes into it and no other", "[program]")
{
  // Water falls askew on a ground along which it slips, and no other wall is near: momentum along the
  // ground stays to rounding, that across it ends.
  ParameterText scene;
  scene.end_time = "0.015";
  scene.gravity  = "0, -9.81";
  scene.add_fluid("water", "1e5", "0.01")
    .add_box("water", "water", "0.12, 0.02", "0.16, 0.06", "set Velocity = 1, -7\n");
  scene.rest = walls(2, "slip");
  const Outcome run =
    run_magmpm(write_scene("askew", scene.text()) + " --set Output/Particles=false");
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const Statistics statistics("output-askew");
  CHECK(statistics.last("held particles") == 0.);
  const double momentum = 1000. * 0.04 * 0.04;
  for (const double along : statistics["momentum x [kg/s]"])
    CHECK(std::abs(along - momentum) < 1e-12 * momentum);
  CHECK(std::abs(statistics.last("momentum y [kg/s]")) < 4. * momentum);
}

TEST_CASE("Particles that leave through an open face end the run, or are removed", "[program]")
{
  // A block of 64 particles flies up and out of the open top. As an error the message says who, where
  // and what to do; removed, they are counted to the last, and the run goes on without any.
  ParameterText scene;
  scene.add_solid("rubber", "1e5")
    .add_box("block", "rubber", "0.12, 0.26", "0.16, 0.3", "set Velocity = 0, 3\n");
  scene.rest             = "subsection Walls\nset Upper y = open\nend\n";
  const std::string file = write_scene("leaving", scene.text());
  const Outcome refused  = run_magmpm(file);
  INFO(refused.errors);
  CHECK(refused.exit_code == 1);
  CHECK(refused.errors.find("left the box by t = ") != std::string::npos);
  CHECK(refused.errors.find(" of body 'block' through 'Upper y', to (0.1") != std::string::npos);
  CHECK(refused.errors.find("with a velocity of (") != std::string::npos);
  CHECK(refused.errors.find("'Particles leaving the box = remove' in the section 'Walls'") !=
        std::string::npos);

  const Outcome run = run_magmpm(file + " --set \"Walls/Particles leaving the box=remove\"", 2);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const Statistics statistics("output-leaving");
  CHECK(statistics.last("lost particles") == 64.);
  CHECK(statistics.last("particles") == 0.);
  for (std::size_t row = 0; row < statistics.n_rows(); ++row)
    CHECK(statistics["lost particles"][row] + statistics["particles"][row] == 64.);
  CHECK(contents("output-leaving/log.txt").find("WARNING: ") != std::string::npos);
}
