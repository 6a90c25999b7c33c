#include "catch.h"
#include "program/equal_runs.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  constexpr double vacuum_permeability = 1.25663706212e-6, pi = 3.14159265358979323846;

  const std::string no_frames = "subsection Output\nset Particles = false\nset Fields = false\n"
                                "set Rigid bodies = false\nset Frame interval = 0.05\nend\n";

  std::string
  magnets(const std::vector<std::pair<std::string, std::string>> &list)
  {
    std::string names, text;
    for (const auto &[name, lines] : list)
      {
        names += (names.empty() ? "" : ", ") + name;
        text += "subsection " + name + "\n" + lines + "end\n";
      }
    return "subsection Magnets\nset List of magnets = " + names + "\n" + text + "end\n";
  }

  /** A magnetized sphere of 20 mm radius and density 7500. */
  std::string
  free_ball(const std::string &position,
            const std::string &magnetization,
            const std::string &lines = "")
  {
    return "set Type = magnetized sphere\nset Radius = 0.02\nset Position = " + position +
           "\nset Magnetization = " + magnetization + "\nset Free = true\nset Density = 7500\n" +
           lines;
  }

  Statistics
  statistics_of(const std::string &name, const ParameterText &scene, const int n_ranks = 1)
  {
    const Outcome outcome = run_magmpm(write_scene(name, scene.text()), n_ranks);
    INFO(outcome.output << outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    return Statistics("output-" + name);
  }

  /** A scene needs a body: a small one far away that nothing acts on. */
  ParameterText
  nothing_but_magnets(const int dim, const std::string &end_time)
  {
    ParameterText scene;
    scene.dim      = dim;
    scene.gravity  = dim == 3 ? "0, 0, 0" : "0, 0";
    scene.box      = dim == 3 ? "0.32, 0.16, 0.16" : "0.32, 0.32";
    scene.end_time = end_time;
    scene.add_box("dust",
                  "rubber",
                  dim == 3 ? "0.3, 0.01, 0.01" : "0.3, 0.01",
                  dim == 3 ? "0.31, 0.02, 0.02" : "0.31, 0.02");
    scene.add_solid("rubber", "1e3");
    return scene;
  }

  std::string
  longest_step(const std::string &step)
  {
    return "subsection Time step\nset Maximum = " + step + "\nend\n";
  }

  /** Distance of two dipoles along their axis after a time, from rest: r'' = -a/r^4, by RK4. */
  double
  distance_of_dipoles(const double strength, double r, const double time)
  {
    double v        = 0.;
    const int n     = 20000;
    const double dt = time / n;
    const auto a    = [&](const double x) { return -strength / (x * x * x * x); };
    for (int i = 0; i < n; ++i)
      {
        const double v1 = v, a1 = a(r);
        const double v2 = v + 0.5 * dt * a1, a2 = a(r + 0.5 * dt * v1);
        const double v3 = v + 0.5 * dt * a2, a3 = a(r + 0.5 * dt * v2);
        const double v4 = v + dt * a3, a4 = a(r + dt * v3);
        r += dt / 6. * (v1 + 2. * v2 + 2. * v3 + v4);
        v += dt / 6. * (a1 + 2. * a2 + 2. * a3 + a4);
      }
    return r;
  }
} // namespace

TEST_CASE("Two free magnets fall towards each other as two dipoles do", "[program]")
{
  // Two spheres magnetized along their line attract like dipoles: F = 3 mu_0 m^2/(2 pi r^4). Their
  // distance, an ordinary differential equation solved apart, falls from 120 to about 80 mm.
  // Symplectic Euler is of first order: with dt = 0.25 ms, 0.2 % of the way. No material, no solve.
  ParameterText scene = nothing_but_magnets(3, "0.33");
  scene.rest          = magnets({{"left", free_ball("0.1; 0.08; 0.08", "1.5e5; 0; 0")},
                                 {"right", free_ball("0.22; 0.08; 0.08", "1.5e5; 0; 0")}}) +
               longest_step("2.5e-4") + no_frames;
  const Statistics statistics = statistics_of("two-magnets", scene);
  const double volume         = 4. / 3. * pi * 0.02 * 0.02 * 0.02;
  const double moment = 1.5e5 * volume, mass = 7500. * volume;
  const double strength = 2. * 3. * vacuum_permeability * moment * moment / (2. * pi * mass);
  const auto &left      = statistics["left: position x [m]"],
             &right     = statistics["right: position x [m]"];
  double error          = 0.;
  for (std::size_t row = 0; row < left.size(); row += 50)
    error = std::max(error,
                     std::abs(right[row] - left[row] -
                              distance_of_dipoles(strength, 0.12, statistics["time [s]"][row])));
  const double way = 0.12 - (right.back() - left.back());
  INFO("way " << way << " m, largest error " << error << " m");
  CHECK(way > 0.03);
  CHECK(error < 2e-3 * way);
  CHECK(statistics.last("magnetic solves") == 0.);
  for (std::size_t row = 0; row < left.size(); ++row)
    CHECK(std::abs(left[row] + right[row] - 0.32) < 1e-12);
  CHECK(statistics["left: force x [N]"].front() ==
        Approx(3. * vacuum_permeability * moment * moment / (2. * pi * std::pow(0.12, 4))));
}

TEST_CASE("Two free magnets pulled together come to rest in contact", "[program]")
{
  // The same, longer and closer: they meet at 40 mm, and stay there, without going through each
  // other or apart. The surfaces are sampled every dx, which leaves facets, and overlaps below a
  // hundredth of dx are tolerated: 3 mm.
  ParameterText scene = nothing_but_magnets(3, "0.4");
  scene.rest =
    magnets({{"left", free_ball("0.125; 0.08; 0.08", "3e5; 0; 0", "set Contact = separate\n")},
             {"right", free_ball("0.195; 0.08; 0.08", "3e5; 0; 0", "set Contact = separate\n")}}) +
    no_frames;
  const Statistics statistics = statistics_of("magnets-meet", scene);
  const double distance       = statistics.last("right: position x [m]") -
                          statistics.last("left: position x [m]");
  INFO("at a distance of " << distance << " m");
  CHECK(distance == Approx(0.04).margin(0.003));
  CHECK(std::abs(statistics.last("left: velocity x [m/s]")) < 0.01);
}

TEST_CASE("A compass needle swings with the period of a pendulum", "[program]")
{
  // A cylinder magnetized across its axis, let go at 150 degrees from a uniform field: I theta'' =
  // -mu_0 m H sin theta, with the period 4 sqrt(I/(mu_0 m H)) K(sin(theta_0/2)), K the complete
  // elliptic integral. The times at which the spin changes its sign are half periods apart; margin
  // 0.2 %.
  const double start = 150. * pi / 180., magnetization = 1e5, field = 2e4;
  ParameterText scene = nothing_but_magnets(2, "1");
  const auto text     = [](const double number) { return std::to_string(number); };
  scene.rest          = magnets({{"needle",
                                  free_ball("0.16; 0.16",
                                   text(magnetization * std::cos(start)) + "; " +
                                     text(magnetization * std::sin(start)))},
                                 {"field", "set Field = " + text(field) + "; 0\n"}}) +
               longest_step("1e-3") + no_frames;
  const Statistics statistics = statistics_of("compass", scene);
  const double per_inertia    = vacuum_permeability * magnetization * field /
                             (0.5 * 7500. * 0.02 * 0.02); // volumes cancel
  const double period = 4. / std::sqrt(per_inertia) * std::comp_ellint_1(std::sin(0.5 * start));

  const auto &spin = statistics["needle: angular velocity z [rad/s]"],
             &time = statistics["time [s]"];
  std::vector<double> turns;
  for (std::size_t row = 2; row < spin.size(); ++row)
    if (spin[row - 1] * spin[row] < 0.)
      turns.push_back(time[row - 1] +
                      (time[row] - time[row - 1]) * spin[row - 1] / (spin[row - 1] - spin[row]));
  REQUIRE(turns.size() >= 3);
  const double found = 2. * (turns.back() - turns.front()) / static_cast<double>(turns.size() - 1);
  INFO("period " << found << " s, " << turns.size() << " turns; exact " << period);
  CHECK(found == Approx(period).epsilon(2e-3));
  CHECK(statistics.last("magnetic solves") == 0.);
  CHECK(std::abs(statistics.last("needle: position x [m]") - 0.16) < 1e-12);
}

namespace
{
  /** A square of soft magnetic rubber and a free magnet beside it, in 2D, without gravity. */
  ParameterText
  square_and_magnet(const std::string &magnetization, const std::string &lines)
  {
    ParameterText scene;
    scene.end_time = "0.042";
    scene.add_box("square", "rubber", "0.16, 0.1", "0.24, 0.18");
    scene.add_solid(
      "rubber", "1e5", "set Saturation magnetization = 4e5\nset Initial susceptibility = 2\n");
    scene.rest =
      magnets({{"ball",
                "set Type = magnetized sphere\nset Radius = 0.03\nset Position = 0.08; 0.17\n"
                "set Magnetization = " +
                  magnetization + "\n" + lines}}) +
      "subsection Magnetics\nset Magnetization law = Langevin\nend\n" + no_frames;
    return scene;
  }
} // namespace

TEST_CASE("Material and a free magnet do to each other what Newton's third law says", "[program]")
{
  // The forces on a magnetized square and on the magnet beside it, oblique, add up to zero but for
  // what the square does to itself, and so do momentum and angular momentum of both, from rest,
  // until they meet: forces and momenta below 2 % of what each of them has, angular momenta, from which
  // the particles take off what a node's force loses as a couple, below 0.2 %. With no magnetization
  // nothing moves.
  const Statistics statistics = statistics_of(
    "third-law", square_and_magnet("6e5; 4e5", "set Free = true\nset Density = 3000\n"));
  const double radius = 0.03, mass = 3000. * pi * radius * radius;
  const double inertia = 0.5 * mass * radius * radius;
  const auto at_end    = [&](const std::string &heading) { return statistics.last(heading); };
  double force = 0., force_sum = 0.;
  for (std::size_t row = 1; row < statistics.n_rows(); ++row)
    for (const std::string axis : {"x", "y"})
      {
        const double of_square = statistics["square: magnetic force " + axis + " [N/m]"][row];
        const double of_ball   = statistics["ball: force " + axis + " [N/m]"][row];
        force                  = std::max(force, std::abs(of_square));
        force_sum              = std::max(force_sum, std::abs(of_square + of_ball));
      }
  INFO("forces add up to " << force_sum / force << " of the largest");
  CHECK(force > 10.);
  CHECK(force_sum < 0.02 * force);

  const double p_x = at_end("momentum x [kg/s]"), p_y = at_end("momentum y [kg/s]");
  const double v_x = at_end("ball: velocity x [m/s]"), v_y = at_end("ball: velocity y [m/s]");
  INFO("momenta " << p_x << ", " << p_y << " and " << mass * v_x << ", " << mass * v_y);
  CHECK(std::hypot(p_x + mass * v_x, p_y + mass * v_y) < 0.02 * std::hypot(p_x, p_y));
  const double spin = inertia * at_end("ball: angular velocity z [rad/s]");
  const double of_ball =
    spin + mass * (at_end("ball: position x [m]") * v_y - at_end("ball: position y [m]") * v_x);
  const double of_square = at_end("angular momentum z [kg m/s]");
  INFO("angular momenta " << of_square << " and " << of_ball << ", spin of the ball " << spin);
  CHECK(std::abs(spin) > 1e-4);
  CHECK(std::abs(of_square + of_ball) < 2e-3 * std::abs(of_square));

  const Statistics off = statistics_of(
    "third-law-off", square_and_magnet("0; 0", "set Free = true\nset Density = 3000\n"));
  CHECK(off.last("ball: force x [N/m]") == 0.);
  CHECK(off.last("ball: torque z [N]") == 0.);
  CHECK(off.last("ball: velocity x [m/s]") == 0.);
}

TEST_CASE("A run with a free magnet can be resumed, on another number of ranks too", "[program]")
{
  // The free magnet flies to the square: all that moves it, the carried force of the last solve
  // among it, is in the checkpoint. To rounding on the same ranks, to 1e-9 on others.
  const std::string scene = write_scene(
    "resume-magnet",
    square_and_magnet("6e5; 4e5", "set Free = true\nset Density = 3000\nset Contact = separate\n")
        .text() +
      "set Checkpoint every = 1 frames\n"
      "subsection Magnetics\nset Newton tolerance = 1e-13\nend\n"
      "subsection Output\nset Frame interval = 0.02\nend\n");
  const auto part = [&](const std::string &folder, const std::string &arguments, const int ranks) {
    const Outcome outcome =
      run_magmpm(scene + " --set \"Output directory=" + folder + "\" " + arguments, ranks);
    INFO(outcome.output << outcome.errors);
    REQUIRE(outcome.exit_code == 0);
  };
  part("magnet-straight", "", 1);
  part("magnet-resumed", "--set \"End time=0.04\"", 1);
  part("magnet-resumed", "--resume", 1);
  part("magnet-ranks", "--set \"End time=0.04\"", 2);
  part("magnet-ranks", "--resume", 1);
  const Statistics straight("magnet-straight");
  check_equal_runs(straight, Statistics("magnet-resumed"), 1e-12, is_wall_time);
  check_equal_runs(straight, Statistics("magnet-ranks"), 1e-9, depends_on_ranks);
  CHECK(std::abs(straight.last("ball: velocity x [m/s]")) > 0.01);
}
