// What scenes of Sun et al. 2021 show, as numbers: the files of parameter_files/ on coarser lattices.

#include "catch.h"
#include "program/particle_frames.h"
#include "program/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace magmpm::testing;

namespace
{
  /** Runs a file of parameter_files/ with other values; its results go to the folder @p name. */
  Outcome
  run_scene(const std::string &file, const std::string &name, const std::string &options)
  {
    return run_magmpm(std::string(MAGMPM_SOURCE_DIR) + "/parameter_files/" + file +
                      " --set \"Output directory=" + name + "\" --set Output/Fields=false " +
                      options);
  }

  /** Distance along x between the particles with x above 0.5 m and those below, in the mean [m]. */
  double
  distance_along_x(const std::vector<std::array<double, 3>> &particles)
  {
    std::array<double, 2> sum{}, count{};
    for (const auto &particle : particles)
      {
        sum[particle[0] > 0.5] += particle[0];
        count[particle[0] > 0.5] += 1.;
      }
    return sum[1] / count[1] - sum[0] / count[0];
  }
} // namespace

TEST_CASE("Cubes in a uniform field attract along it and repel across it", "[program]")
{
  // Fig. 11. Two magnetized cubes are like dipoles, which attract where they lie behind one another
  // along their moments, and repel with half of that force side by side. Without a field nothing moves.
  const auto change_in = [](const std::string &name, const std::string &field) {
    const Outcome run = run_scene("induced_attraction.prm",
                                  "attraction-" + name,
                                  "--set \"Magnets/coil/Field=" + field +
                                    "\" --set \"Box/Cell size=0.015625\" --set \"End time=0.1\" "
                                    "--set \"Output/Frame interval=0.1\"");
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    const auto frames = particle_frames("attraction-" + name);
    REQUIRE(frames.size() == 2);
    return distance_along_x(frames[1]) - distance_along_x(frames[0]);
  };
  const double along  = change_in("along", "8e4; 0; 0");
  const double across = change_in("across", "0; 8e4; 0");
  const double off    = change_in("off", "0; 0; 0");
  std::printf(
    "two cubes after 0.1 s: distance changed by %.2f mm in a field along it, %.2f mm across, "
    "%.2g mm without\n",
    1e3 * along,
    1e3 * across,
    1e3 * off);
  CHECK(along < -5e-3);
  CHECK(across > 2e-3);
  CHECK(std::abs(off) < 1e-6);
}

TEST_CASE("At a strong magnet the linear law crushes a cube and Langevin's does not", "[program]")
{
  // Fig. 7. The linear law has M grow with the field without end, Langevin's saturates: M is at most
  // M_s/J = 82 kA/m/J. Cells of 1/32 m resolve less of what happens at the pole: there the limit of
  // what counts as crushed is J = 0.09, with 1/128 m it is 0.05.
  const std::string options = "--set \"Box/Cell size=0.03125\" --set Output/Particles=false "
                              "--set \"Runaway limits/Minimum volume ratio=0.09\"";
  const Outcome linear      = run_scene("cube_linear.prm", "crushed", options);
  CHECK(linear.exit_code == 1);
  CHECK(linear.errors.find("of body 'cube' ran away") != std::string::npos);
  const Statistics crushed("crushed");

  const Outcome langevin = run_scene("cube_nonlinear.prm", "whole", options);
  INFO(langevin.errors);
  REQUIRE(langevin.exit_code == 0);
  const Statistics whole("whole");
  double smallest = 1., strongest = 0.;
  for (std::size_t row = 0; row < whole.n_rows(); ++row)
    {
      smallest  = std::min(smallest, whole["min J [-]"][row]);
      strongest = std::max(strongest,
                           whole["max |M| [A/m]"][row] * std::min(1., whole["min J [-]"][row]));
    }
  std::printf(
    "cube at a magnet: linear crushed to J = %.3f with M = %.2g A/m at t = %.4f s; Langevin "
    "J >= %.3f, M J <= %.3g A/m\n",
    crushed.last("min J [-]"),
    crushed.last("max |M| [A/m]"),
    crushed.last("time [s]"),
    smallest,
    strongest);
  CHECK(crushed.last("max |M| [A/m]") > 1e6);
  CHECK(strongest < 8.3e4);
  CHECK(whole.last("time [s]") == Approx(0.25));
  // It hangs on the ball, whose top is at 0.2 m, and has not flown to pieces.
  CHECK(whole.last("centre of mass z [m]") > 0.15);
  CHECK(whole.last("centre of mass z [m]") < 0.35);
  CHECK(whole.last("max J [-]") < 3.);
}
