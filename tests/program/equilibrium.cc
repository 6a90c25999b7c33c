#include "catch.h"

#include "program/parameter_text.h"

#include <magmpm/base/constants.h>

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

// What brings scenes to rest, and the artificial force that is compared with a magnet's.

namespace
{
  /** A small disc of a stiff solid, 0.16 m to the left of the point (0.24, 0.16). */
  ParameterText
  disc()
  {
    ParameterText scene;
    scene.add_solid(
      "rubber", "1e6", "set Saturation magnetization = 4e5\nset Initial susceptibility = 1\n");
    scene.bodies = {{"disc",
                     "set Material = rubber\nset Density = 1000\nset Shape = sphere\n"
                     "set Centre = 0.08, 0.16\nset Radius = 0.02\n"}};
    scene.rest   = "subsection Output\nset Frame interval = 0.01\nset Particles = false\n"
                   "set Fields = false\nend\n";
    return scene;
  }

  const std::string magnet = "subsection Magnets\nset List of magnets = ball\nsubsection ball\n"
                             "set Type = magnetized sphere\nset Position = 0.24; 0.16\n"
                             "set Magnetization = 1e6; 0\nset Radius = 0.03\nend\nend\n";

  Statistics
  statistics_of(const std::string &name, const ParameterText &scene)
  {
    const Outcome run = run_magmpm(write_scene(name, scene.text()));
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    return Statistics("output-" + name);
  }
} // namespace

TEST_CASE("A body falls to an attracting point as it must", "[program]")
{
  // From rest at R = 0.16 m in g0 (r0/r)^2, mu = g0 r0^2: it has gone half of the way after
  //   t = sqrt(R^3/(2 mu)) (sqrt(x (1 - x)) + acos(sqrt(x))),  x = 1/2,
  // 0.115 s; a disc of R/8 is drawn up to 1 % differently from a point. Its momentum points to the
  // point, and without the attraction it stays where it is.
  ParameterText scene         = disc();
  const double g0             = 10.;
  const double t_half         = std::sqrt(0.16 / (2. * g0)) * (0.5 + 0.25 * magmpm::constants::pi);
  scene.end_time              = "0.12";
  const std::string output    = scene.rest;
  const std::string the_point = "subsection Attraction\nset Strength = 10\nset Point = 0.24, 0.16\n"
                                "set Reference distance = 0.16\nset Exponent = 2\n";
  scene.rest                  = output + the_point + "end\n";
  const Statistics fall       = statistics_of("attracted", scene);
  const auto &time            = fall["time [s]"];
  const auto &x               = fall["centre of mass x [m]"];
  std::size_t row             = 0;
  while (row + 1 < time.size() && x[row] < 0.16)
    ++row;
  const double arrival = time[row - 1] +
                         (time[row] - time[row - 1]) * (0.16 - x[row - 1]) / (x[row] - x[row - 1]);
  INFO("half of the way at " << arrival << " s, by the formula " << t_half);
  CHECK(arrival == Approx(t_half).epsilon(0.015));
  CHECK(std::abs(fall.last("momentum y [kg/s]")) < 1e-9 * fall.last("momentum x [kg/s]"));

  scene.rest = output + the_point + "set Bodies = disc\nend\n";
  CHECK(statistics_of("attracted-by-name", scene).last("momentum x [kg/s]") ==
        fall.last("momentum x [kg/s]"));
  scene.rest = output;
  CHECK(statistics_of("not-attracted", scene).last("momentum x [kg/s]") == 0.);
}

TEST_CASE("A matched attraction has the force of the magnets", "[program]")
{
  // The first step of two runs without gravity, one with the magnet and one with what replaces it: the
  // momentum over the time is the force, in x since the disc lies on the axis. Afterwards there is one
  // solve only.
  ParameterText scene       = disc();
  scene.end_time            = "0.002";
  const std::string output  = scene.rest;
  scene.rest                = output + magnet;
  const Statistics magnetic = statistics_of("with-magnet", scene);
  scene.rest                = output + magnet + "subsection Attraction\n" +
               "set Strength = match magnets\nset Point = 0.24, 0.16\nend\n";
  const Statistics artificial = statistics_of("with-attraction", scene);
  const auto force            = [](const Statistics &statistics) {
    return statistics["momentum x [kg/s]"][1] / statistics["time [s]"][1];
  };
  CHECK(magnetic["disc: magnetic force x [N/m]"][0] == Approx(force(magnetic)).epsilon(1e-9));
  CHECK(force(artificial) == Approx(force(magnetic)).epsilon(1e-6));
  CHECK(force(magnetic) > 0.);
  CHECK(artificial.last("magnetic solves") == 1.);
  CHECK(artificial.last("disc: magnetic force x [N/m]") == 0.);
  CHECK(contents("output-with-attraction/log.txt").find("attraction: g0 = ") != std::string::npos);

  const Outcome refused = run_magmpm(
    write_scene("nothing-to-match",
                disc().text() +
                  "subsection Attraction\nset Strength = match magnets\nset Point = 0, 0\nend\n"));
  CHECK(refused.exit_code == 2);
  CHECK(refused.errors.find("there are no magnets to match. Give the acceleration.") !=
        std::string::npos);
}

TEST_CASE("A run ends when all is at rest", "[program]")
{
  // A block that falls on the floor and is damped: the run ends long before its end time, says why, has
  // exit code 0, a last frame and a last row, and is as slow as it was asked to be. Resumed from a
  // checkpoint in the middle it ends in the same step; undamped it does not come to rest.
  ParameterText scene;
  scene.end_time = "5";
  scene.gravity  = "0, -9.81";
  scene.add_solid("rubber", "2e4").add_box("block", "rubber", "0.1, 0.01", "0.2, 0.09");
  const std::string output = "subsection Output\nset Frame interval = 0.05\n"
                             "set Statistics every = 1000\nend\nset Checkpoint every = 4 frames\n";
  const std::string rest  = "subsection Rest\nset Damping rate = 20\nset Stop when at rest = true\n"
                            "set Speed = 0.002\nset Time = 0.05\nend\n";
  scene.rest              = output + rest;
  const Statistics damped = statistics_of("damped", scene);
  const std::string log   = contents("output-damped/log.txt");
  CHECK(
    log.find("ended since all material is at rest: slower than 2 mm/s (root mean square) for 50 "
             "ms") != std::string::npos);
  CHECK(damped.last("time [s]") < 2.);
  CHECK(damped.last("time [s]") > 0.1);
  const double mass = 1000. * 0.1 * 0.08;
  CHECK(std::sqrt(2. * damped.last("kinetic energy [J/m]") / mass) < 0.002);
  // It lies on the floor, which holds what is less than a cell above it.
  CHECK(damped.last("centre of mass y [m]") < 0.0475);
  CHECK(damped.last("centre of mass y [m]") > 0.038);

  // The same in two parts: the time since when it is at rest is in the checkpoint.
  const std::string scene_file = write_scene("damped-in-two", scene.text());
  const double middle          = damped.last("time [s]") - 0.03;
  REQUIRE(run_magmpm(scene_file + " --set \"End time=" + std::to_string(middle) + "\"").exit_code ==
          0);
  REQUIRE(run_magmpm(scene_file + " --resume").exit_code == 0);
  CHECK(Statistics("output-damped-in-two").last("time [s]") ==
        Approx(damped.last("time [s]")).margin(0.005));

  scene.rest     = output + "subsection Rest\nset Stop when at rest = true\nset Speed = 0.002\n"
                            "set Time = 0.05\nend\n";
  scene.end_time = "0.5";
  const Statistics undamped = statistics_of("undamped", scene);
  CHECK(undamped.last("step") == 0.); // no row after the first: nothing ended it before its time
  CHECK(contents("output-undamped/log.txt").find("ended at the end time") != std::string::npos);
}
