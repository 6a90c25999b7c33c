// The stability limits of the time step, one by one: a scene in which the limit binds runs well with
// the steps that the program takes, a fixed step four times as long is refused, and shown to be
// wrong where the user insists on it.

#include "catch.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <algorithm>
#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  /** Lifts the limits of the time step other than @p limit. */
  std::string
  without_other_limits(const std::string &limit)
  {
    std::string options;
    for (const std::string other : {"Elastic", "Viscous", "Force", "Affine"})
      if (other != limit)
        options += "--set \"Time step/" + other + " factor=1e4\" ";
    return options;
  }

  /** The shortest step that was not cut short, and the largest total energy over that at the start. */
  struct Course
  {
    double time_step      = 1e300;
    double energy_at_most = 0.;
  };

  Course
  course_of(const std::string &folder)
  {
    const Statistics statistics(folder);
    const std::vector<double> energy = mechanical_energy(statistics);
    Course course;
    for (std::size_t row = 1; row + 2 < statistics.n_rows(); ++row)
      course.time_step = std::min(course.time_step, statistics["dt [s]"][row]);
    course.energy_at_most = *std::max_element(energy.begin(), energy.end()) / energy.front();
    return course;
  }

  /** The step of the run in @p folder times 4 as an option. */
  std::string
  four_times_the_step_of(const std::string &folder)
  {
    return "--set \"Time step/Time step=" + std::to_string(4. * course_of(folder).time_step) +
           "\" ";
  }

  const std::string no_output    = "--set Output/Particles=false --set Output/Fields=false "
                                   "--set \"Output/Frame interval=1\" ";
  const std::string all_the_same = "--set \"Time step/Allow unstable time step=true\" ";

  /** Runs the scene at the steps of the program; checks that the limit binds and four times it is refused. */
  void
  check_limit(const std::string &file,
              const std::string &folder,
              const std::string &limit,
              const std::string &options)
  {
    const Outcome run = run_magmpm(file + " " + no_output + options);
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    REQUIRE(rows_with(folder, limit) > 5);
    const std::string long_step = four_times_the_step_of(folder);
    const Outcome refused       = run_magmpm(file + " " + no_output + options + long_step +
                                       "--set \"Output directory=" + folder + "-refused\"");
    INFO(refused.errors);
    CHECK(refused.exit_code != 0);
    CHECK(refused.errors.find("is longer than the " + limit + " limit, ") != std::string::npos);
  }

  /** What happens with a fixed step of four times that of @p folder. */
  Outcome
  insisting_run(const std::string &file, const std::string &folder, const std::string &options)
  {
    return run_magmpm(file + " " + no_output + options + all_the_same +
                      four_times_the_step_of(folder) + "--set \"Output directory=" + folder +
                      "-insisting\"");
  }
} // namespace

TEST_CASE("The elastic limit keeps a vibrating bar stable", "[program]")
{
  // A bar that sticks to a wall at one end and starts with a velocity along itself vibrates, by 5 %
  // of strain. With a factor of 0.4 energy never rises; the bar goes astray from 1.2 to 1.4 on.
  ParameterText scene;
  scene.add_box("bar", "rubber", "0, 0.14", "0.2, 0.18", "set Velocity = 0.5, 0")
    .add_solid("rubber", "1e5");
  const std::string file   = write_scene("vibrating-bar", scene.text()),
                    folder = "output-vibrating-bar";
  check_limit(file, folder, "elastic", "");
  CHECK(course_of(folder).energy_at_most <= 1. + 1e-12);
  const Outcome run = insisting_run(file, folder, "");
  CHECK(run.exit_code == 1);
  CHECK(run.errors.find("of body 'bar' ran away at t = ") != std::string::npos);
}

namespace
{
  /** A drop of 100 Pa s, of few and irregular particles, falls on the ground at an angle. @return its file. */
  std::string
  viscous_drop()
  {
    ParameterText scene;
    scene.end_time = "0.05";
    scene.gravity  = "0, -9.81";
    scene.add_fluid("honey", "1e5", "100");
    scene.bodies.emplace_back("drop",
                              "set Material = honey\nset Density = 1000\nset Shape = sphere\n"
                              "set Centre = 0.16, 0.05\nset Radius = 0.04\nset Velocity = 1, -1\n"
                              "set Particles per edge = 1\nset Jitter = 1\n");
    return write_scene("viscous-drop", scene.text());
  }

  const std::string folder_of_drop = "output-viscous-drop";
} // namespace

TEST_CASE("The viscous limit keeps a viscous drop stable", "[program]")
{
  // With a factor of 0.12 energy falls but for what the next test says, from 0.36 on it rises; with few and irregular
  // particles 0.48 is a runaway.
  const std::string file = viscous_drop(), folder = folder_of_drop;
  check_limit(file, folder, "viscous", "");
  CHECK(course_of(folder).energy_at_most <= 1.001);
  const std::string only = without_other_limits("Viscous");
  const Outcome run      = run_magmpm(file + " " + no_output + only +
                                 "--set \"Time step/Viscous factor=0.48\" "
                                      "--set \"Output directory=output-viscous-drop-insisting\"");
  CHECK((run.exit_code == 1 || course_of("output-viscous-drop-insisting").energy_at_most > 2.));
}

TEST_CASE("Irregular particles of a viscous drop bring no energy", "[program][!shouldfail]")
{
  // A limit that is missed: energy never rises over that at the start. Particles that begin too close to each other are
  // pushed apart by the relaxation of the density, which adds 0.04 %. Whoever mends that is told so by this test.
  const Outcome run = run_magmpm(viscous_drop() + " " + no_output);
  REQUIRE(run.exit_code == 0);
  CHECK(course_of(folder_of_drop).energy_at_most <= 1. + 1e-12);
}

TEST_CASE("The affine limit keeps a fast spin from turning particles inside out", "[program]")
{
  // A soft block spins faster than it can bear and tears. Steps of 0.3/|C| keep J above zero and the
  // energy, which symplectic Euler sways by O(dt), within 15 %; steps of 1.2/|C| turn F inside out.
  ParameterText scene;
  scene.end_time = "0.05";
  scene.add_box("block", "jelly", "0.13, 0.14", "0.19, 0.18", "set Angular velocity = 100")
    .add_solid("jelly", "3e3");
  const std::string file = write_scene("fast-spin", scene.text()), folder = "output-fast-spin";
  const std::string only = without_other_limits("Affine");
  check_limit(file, folder, "affine", only);
  CHECK(course_of(folder).energy_at_most < 1.15);
  CHECK(Statistics(folder).last("min J [-]") > 0.5);
  const Outcome run = insisting_run(file, folder, only);
  CHECK(run.exit_code == 1);
  CHECK(run.errors.find("of body 'block' ran away at t = ") != std::string::npos);
}

TEST_CASE("The force limit keeps a strong pull from jumping cells", "[program]")
{
  // A block at rest is pulled at 3e4 m/s^2 through empty space: a step of 0.3 sqrt(dx/a) takes it 0.09
  // dx far from rest. Energy is that of a body that falls.
  ParameterText scene;
  scene.end_time = "0.002";
  scene.gravity  = "0, -3e4";
  scene.add_box("block", "rubber", "0.13, 0.2", "0.19, 0.24").add_solid("rubber", "1e5");
  const std::string file = write_scene("strong-pull", scene.text()), folder = "output-strong-pull";
  check_limit(file, folder, "force", without_other_limits("Force"));
  CHECK(course_of(folder).time_step == Approx(0.3 * std::sqrt(0.01 / 3e4)));
  CHECK(course_of(folder).energy_at_most <= 1. + 1e-10);
}

TEST_CASE("The magnetic limit keeps a magnetized cube stable", "[program]")
{
  // A soft block of M_s = 400 kA/m in a field that saturates it: magnetic waves, sqrt(mu_0 M^2/rho) =
  // 14 m/s, are faster than elastic ones at 12 m/s. It is stretched and swings, and runs to the end.
  ParameterText scene;
  scene.end_time = "0.03";
  scene.add_box("block", "rubber", "0.12, 0.16", "0.2, 0.24")
    .add_solid(
      "rubber", "1e5", "set Saturation magnetization = 4e5\nset Initial susceptibility = 2\n");
  scene.rest               = "subsection Magnets\nset List of magnets = coil\nsubsection coil\n"
                             "set Type = uniform field\nset Field = 0; 1e6\nend\nend\n";
  const std::string file   = write_scene("magnetized-block", scene.text());
  const std::string folder = "output-magnetized-block";
  check_limit(file, folder, "elastic", "");
  const Statistics statistics(folder);
  for (std::size_t row = 2; row + 2 < statistics.n_rows(); ++row)
    {
      const double magnetic_speed = statistics["max |M| [A/m]"][row] *
                                    std::sqrt(4e-7 * 3.14159265 / 1000.);
      CHECK(statistics["dt [s]"][row] < 0.42 * 0.01 / (magnetic_speed + 11.));
    }
  CHECK(statistics.last("max J [-]") < 3.);
}

TEST_CASE("A limit that falls below a fixed step in the course of a run ends it", "[program]")
{
  // A block falls at rest and dt is 0.99 of its limit at the start: as soon as it moves the sum of
  // wave speed and velocity refuses it. The frames up to there are kept.
  ParameterText scene;
  scene.gravity = "0, -100";
  scene.add_box("block", "rubber", "0.13, 0.2", "0.19, 0.24").add_solid("rubber", "1e5");
  const Outcome run = run_magmpm(write_scene("falling-out", scene.text()) +
                                 " --set \"Time step/Time step=3.4e-4\" "
                                 "--set \"Output/Frame interval=0.001\"");
  INFO(run.errors);
  CHECK(run.exit_code == 1);
  CHECK(run.errors.find("the given Time step/Time step (0.00034 s) is longer than the elastic "
                        "limit, 0.0003") != std::string::npos);
  CHECK(contents("output-falling-out/log.txt").find("the elastic limit") != std::string::npos);
  CHECK(Statistics("output-falling-out").n_rows() > 2);
}
