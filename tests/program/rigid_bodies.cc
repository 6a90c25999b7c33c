#include "catch.h"
#include "program/equal_runs.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  const std::string no_frames = "subsection Output\nset Particles = false\nset Fields = false\n"
                                "set Rigid bodies = false\nset Frame interval = 0.05\nend\n";

  /** A rigid box in the section of rigid bodies. */
  std::string
  rigid_box(const std::string &lower, const std::string &upper, const std::string &lines)
  {
    return "subsection Rigid bodies\nset List of rigid bodies = raft\nsubsection raft\n"
           "set Lower corner = " +
           lower + "\nset Upper corner = " + upper + "\n" + lines + "end\nend\n";
  }

  Statistics
  statistics_of(const std::string &name, const ParameterText &scene, const int n_ranks = 1)
  {
    const Outcome outcome = run_magmpm(write_scene(name, scene.text()), n_ranks);
    INFO(outcome.output << outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return Statistics("output-" + name);
  }

  /** A pool 12 cells deep, and a box 8 cells wide and high just above it. */
  ParameterText
  pool_and_box(const std::string &density, const std::string &lines = "")
  {
    ParameterText scene;
    scene.gravity  = "0, -9.81";
    scene.box      = "0.32, 0.32";
    scene.end_time = "1.6";
    scene.add_box("pool", "oil", "0, 0", "0.32, 0.12").add_fluid("oil", "5e4", "3");
    scene.rest = rigid_box("0.12, 0.121", "0.2, 0.201", "set Density = " + density + "\n" + lines) +
                 no_frames;
    return scene;
  }

  double
  speed_after(const Statistics &statistics, const double time)
  {
    const auto &times = statistics["time [s]"];
    const auto row    = std::lower_bound(times.begin(), times.end(), time) - times.begin();
    return statistics["raft: velocity x [m/s]"].at(row);
  }
} // namespace

TEST_CASE("A light body floats as deep as Archimedes says, a heavy one sinks", "[program]")
{
  // A box of half the fluid's density displaces half its volume: the pool, 0.32 m wide and 0.12 m
  // deep, rises by 0.01 m, and the centre of the box lies in its surface, at 0.13 m. At 0.25 of the
  // density it is 0.02 m higher over a pool 0.005 m lower. One of twice the density lies on the
  // floor. Its own weight makes the pool rho g h^2/(2 K) = 1.5 mm lower. The margin is 0.4 dx: at an edge a
  // node has one normal.
  for (const auto &[density, height] : {std::pair("500", 0.1285), std::pair("250", 0.1435)})
    {
      const Statistics statistics = statistics_of(std::string("floating-") + density,
                                                  pool_and_box(density));
      const double found          = late_mean(statistics["raft: position y [m]"]);
      INFO("density " << density << ": centre at " << found << " m, Archimedes: " << height);
      CHECK(std::abs(found - height) < 0.004);
      CHECK(std::abs(statistics.last("raft: velocity y [m/s]")) < 0.02);
      INFO("deepest penetration " << late_mean(statistics["deepest penetration [m]"]));
      CHECK(late_mean(statistics["deepest penetration [m]"]) < 0.001);
    }
  const Statistics heavy = statistics_of("sinking", pool_and_box("2000"));
  INFO("the heavy one lies at " << heavy.last("raft: position y [m]"));
  CHECK(heavy.last("raft: position y [m]") < 0.05);
  CHECK(heavy.last("raft: position y [m]") > 0.0395);
}

namespace
{
  /** A slab of fluid slides on a frictionless floor at 0.5 m/s, a light raft at rest is laid on it. */
  Statistics
  carried(const std::string &name, const std::string &contact)
  {
    ParameterText scene;
    scene.gravity  = "0, -9.81";
    scene.box      = "1.28, 0.16";
    scene.end_time = "0.3";
    scene.add_box("slab", "oil", "0.4, 0", "0.64, 0.06", "set Velocity = 0.5, 0\n")
      .add_fluid("oil", "2e4", "20");
    scene.rest =
      rigid_box("0.49, 0.0605", "0.55, 0.0905", "set Density = 100\n" + contact) +
      "subsection Walls\nset Lower y = slip\nset Lower x = slip\nset Upper x = slip\nend\n" +
      no_frames;
    return statistics_of(name, scene);
  }
} // namespace

TEST_CASE("A body on a fluid that it sticks to is carried at its speed", "[program]")
{
  // Nothing else pushes along x, so that momentum goes from one to the other, none is lost (to
  // rounding), and in the end both have the mean velocity. With a slipping raft and no friction it
  // stays behind, until the fluid has risen behind it.
  const Statistics statistics = carried("carried", "set Contact = stick\n");
  const double mass           = 100. * 0.06 * 0.03;
  const auto &raft            = statistics["raft: velocity x [m/s]"];
  const auto &momentum        = statistics["momentum x [kg/s]"];
  double change               = 0.;
  for (std::size_t row = 0; row < raft.size(); ++row)
    change = std::max(change, std::abs(momentum[row] + mass * raft[row] - momentum[0]));
  INFO("momentum changed by " << change / momentum[0] << " of itself");
  CHECK(change < 1e-11 * momentum[0]);
  const double mean = momentum.back() / (1000. * 0.24 * 0.06);
  INFO("fluid at " << mean << " m/s, raft at " << raft.back());
  CHECK(raft.back() == Approx(mean).epsilon(0.05));

  const Statistics slipping = carried("left-behind", "set Contact = slip\n");
  CHECK(speed_after(statistics, 0.02) > 0.8 * mean);
  CHECK(std::abs(speed_after(slipping, 0.02)) < 0.4 * mean); // what there is: see the next test
}

TEST_CASE("A body along which a fluid slips stays behind", "[program][!shouldfail]")
{
  // A limit that is missed: after 0.02 s it has less than 0.3 of the mean velocity. It has 0.33, and why is
  // not known. Whoever mends that is told so by this test.
  const Statistics slipping = carried("left-behind", "set Contact = slip\n");
  const double mean         = slipping["momentum x [kg/s]"].front() / (1000. * 0.24 * 0.06);
  CHECK(std::abs(speed_after(slipping, 0.02)) < 0.3 * mean);
}

TEST_CASE("Rigid bodies do the same on one and on two ranks", "[program]")
{
  // A box falls into the pool and turns. The ranks hold parts of the fluid and sum what it does to
  // the box: only the order of sums differs, 1e-9 of each column's size in 0.1 s.
  ParameterText scene  = pool_and_box("700",
                                     "set Angular velocity = 5\nset Velocity = 0.3, -0.5\n"
                                      "set Contact = separate\nset Friction = 0.3\n");
  scene.end_time       = "0.1";
  const Statistics one = statistics_of("raft-1", scene), two = statistics_of("raft-2", scene, 2);
  check_equal_runs(one, two, 1e-9, depends_on_ranks);
  CHECK(std::abs(one.last("raft: angular velocity z [rad/s]") - 5.) > 0.1);
}

TEST_CASE("A scripted body goes where it is told and pushes what is there", "[program]")
{
  // A paddle moves through a pool at 0.2 m/s whatever the fluid does, and the fluid in front rises.
  ParameterText scene;
  scene.gravity  = "0, -9.81";
  scene.box      = "0.32, 0.16";
  scene.end_time = "0.3";
  scene.add_box("left", "oil", "0, 0", "0.08, 0.06")
    .add_box("right", "oil", "0.11, 0", "0.32, 0.06")
    .add_fluid("oil", "2e4", "1");
  scene.rest = rigid_box("0.08, 0",
                         "0.11, 0.14",
                         "set Motion = scripted\nset Position = 0.095 + 0.2*t; 0.07\n") +
               no_frames;
  const Statistics statistics = statistics_of("paddle", scene);
  CHECK(statistics.last("raft: velocity x [m/s]") == Approx(0.2).epsilon(1e-6));
  CHECK(statistics.last("raft: position x [m]") == Approx(0.155).epsilon(0.01));
  const auto &centre = statistics["centre of mass y [m]"];
  CHECK(centre.back() > centre.front() + 0.001);
  CHECK(statistics.last("deepest penetration [m]") < 0.0061);
}
