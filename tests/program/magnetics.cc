#include "catch.h"
#include "program/equal_runs.h"

#include <verification/program/paths.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <algorithm>
#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  /**
   * A soft magnetic block of 8^3 cells of dx = 10 mm that flies towards a magnet, rather fast: its
   * particles pass several cells in 100 steps.
   */
  std::string
  flying_block(const std::string &name, const std::string &law)
  {
    return write_scene(name,
                       R"(
set Dimension = 3
set End time  = 0.03
set Gravity   = 0, 0, -9.81
subsection Box
  set Upper corner = 0.32, 0.32, 0.32
  set Cell size    = 0.01
end
subsection Bodies
  set List of bodies = block
  subsection block
    set Material     = rubber
    set Shape        = box
    set Lower corner = 0.12, 0.12, 0.14
    set Upper corner = 0.20, 0.20, 0.22
    set Density      = 1000
    set Velocity     = 1.0, 0.5, -0.8
    set Angular velocity = 5, 0, 10
  end
end
subsection Materials
  set List of materials = rubber
  subsection rubber
    set Mechanical law           = neo-Hookean
    set Young's modulus          = 1e5
    set Poisson ratio            = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility   = 0.9
  end
end
subsection Magnets
  set List of magnets = ball
  subsection ball
    set Type          = magnetized sphere
    set Position      = 0.16; 0.16; 0.04
    set Radius        = 0.04
    set Magnetization = 0; 0; 5e5
    set Contact       = separate
  end
end
subsection Magnetics
  set Magnetization law = )" +
                         law + R"(
  set Newton tolerance  = 1e-13
end
subsection Output
  set Frame interval = 0.015
  set Particles = false
  set Fields    = false
end
)");
  }

  const std::string fixed_schedule = " --set \"Time step/Time step=2.5e-4\" "
                                     "--set \"Magnetics/Solve/When=every n steps\" "
                                     "--set \"Magnetics/Solve/Steps=10\" ";
} // namespace

TEST_CASE("The number of ranks changes nothing", "[program]")
{
  // The same 100 steps on 1, 2, 3, 4 and 8 ranks, at a fixed step and fixed solves converged to 1e-13:
  // only the order of sums differs, so all statistics agree to 1e-10 of the largest value of their
  // column. The one body is cut by a rank boundary and its particles change ranks, or nothing is shown.
  // So many particles that all of 8 ranks hold some: the cells of the potential weigh, too.
  const std::string scene = flying_block("ranks", "Langevin") +
                            " --set \"Bodies/block/Particles per edge=4\"";
  const auto run_on = [&](const int n_ranks) {
    const std::string folder = "ranks-" + std::to_string(n_ranks);
    const Outcome run =
      run_magmpm(scene + fixed_schedule + "--set \"Output directory=" + folder + "\"", n_ranks);
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    return Statistics(folder);
  };
  const Statistics one = run_on(1);
  REQUIRE(one.n_rows() == 121);
  REQUIRE(one.last("magnetic solves") >= 10.);

  for (const int n_ranks : {2, 3, 4, 8})
    {
      const Statistics other = run_on(n_ranks);
      INFO(n_ranks << " ranks");
      check_equal_runs(one, other, 1e-10, depends_on_ranks);
      CHECK(other.last("migrated particles") > 0.);
      const auto &fewest = other["fewest particles of a rank"];
      CHECK(*std::min_element(fewest.begin(), fewest.end()) > 0.);
      if (n_ranks == 2)
        CHECK(*std::min_element(fewest.begin(), fewest.end()) >= 0.25 * one.last("particles"));
    }
}

TEST_CASE("A scene pays for what it needs", "[program]")
{
  // Without magnetic material there is no solve and no mesh of a potential; a linear law is one
  // linear system, so one Newton step; what hardly changes is solved once, and once more when it has come to rest a
  // hundredth of dx elsewhere. The statistics count them.
  SECTION("nothing magnetic")
  {
    const Outcome run = run_magmpm(source_folder() +
                                   "/parameter_files/falling_block.prm --set \"End time=0.05\" "
                                   "--set \"Output directory=not-magnetic\"");
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    const Statistics statistics("not-magnetic");
    CHECK(statistics.last("magnetic solves") == 0.);
    CHECK(statistics.last("potential unknowns") == 0.);
    CHECK(contents("not-magnetic/fields.pvd").empty());
  }
  SECTION("linear law")
  {
    const Outcome run = run_magmpm(flying_block("linear", "linear") + fixed_schedule +
                                   "--set \"Magnetics/Newton tolerance=1e-8\"");
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    const Statistics statistics("output-linear");
    CHECK(statistics.last("magnetic solves") >= 10.);
    const auto &steps  = statistics["Newton steps"];
    const auto &solves = statistics["magnetic solves"];
    CHECK(steps.front() == 1.);
    for (std::size_t row = 1; row < steps.size(); ++row)
      CHECK(steps[row] == solves[row] - solves[row - 1]);
  }
  SECTION("static field and body")
  {
    const Outcome run = run_magmpm(source_folder() +
                                   "/parameter_files/uniform_sphere.prm "
                                   "--set \"Output directory=static\" --set Output/Fields=false");
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    const Statistics statistics("static");
    CHECK(statistics.n_rows() > 10);
    CHECK(statistics.last("magnetic solves") <= 2.);
    CHECK(statistics.last("potential unknowns") > 1000.);
  }
}
