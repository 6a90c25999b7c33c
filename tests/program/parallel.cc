#include "catch.h"
#include "program/equal_runs.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  /** One or more squares of soft magnetic rubber in a 2D box of 64 x 64 cells of dx = 10 mm, at fixed steps. */
  std::string
  flying_squares(const std::string &name,
                 const std::string &list,
                 const std::string &bodies,
                 const std::string &material)
  {
    return write_scene(name,
                       R"(
set Dimension = 2
set End time  = 0.03
set Gravity   = 0, 0
subsection Box
  set Upper corner = 0.64, 0.64
  set Cell size    = 0.01
end
subsection Bodies
  set List of bodies = )" +
                         list + bodies + R"(
end
subsection Materials
  set List of materials = rubber
  subsection rubber
)" + material + R"(
  end
end
subsection Magnets
  set List of magnets = field
  subsection field
    set Field = 0; 1e4
  end
end
subsection Magnetics
  set Newton tolerance = 1e-13
  subsection Solve
    set When  = every n steps
    set Steps = 10
  end
end
subsection Time step
  set Time step = 1e-4
end
subsection Output
  set Frame interval = 0.03
  set Particles      = false
  set Fields         = false
end
)");
  }

  std::string
  square(const std::string &name,
         const std::string &lower,
         const std::string &upper,
         const std::string &velocity)
  {
    return "\n  subsection " + name + "\n    set Material = rubber\n    set Density = 1000" +
           "\n    set Lower corner = " + lower + "\n    set Upper corner = " + upper +
           "\n    set Velocity = " + velocity + "\n    set Angular velocity = 20\n  end";
  }

  const std::string elastic  = "    set Young's modulus = 1e4\n    set Poisson ratio = 0.3\n";
  const std::string magnetic = elastic + "    set Saturation magnetization = 8e4\n"
                                         "    set Initial susceptibility = 0.9\n";

  Statistics
  statistics_on(const std::string &scene, const std::string &name, const int n_ranks)
  {
    const std::string folder = name + "-on-" + std::to_string(n_ranks);
    const Outcome run = run_magmpm(scene + " --set \"Output directory=" + folder + "\"", n_ranks);
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    return Statistics(folder);
  }

  double
  largest(const std::vector<double> &column)
  {
    return *std::max_element(column.begin(), column.end());
  }

  double
  smallest(const std::vector<double> &column)
  {
    return *std::min_element(column.begin(), column.end());
  }
} // namespace

TEST_CASE("Ranks without particles change nothing", "[program]")
{
  // One body within a single block on 4 ranks: some of them hold no particle at all, and the run is the
  // same as on one rank.
  const std::string scene = flying_squares("single-block",
                                           "dot",
                                           square("dot", "0.325, 0.325", "0.345, 0.345", "0.05, 0"),
                                           magnetic) +
                            " --set \"End time=0.006\"";
  const Statistics one  = statistics_on(scene, "single-block", 1);
  const Statistics four = statistics_on(scene, "single-block", 4);
  REQUIRE(one.n_rows() == 61);
  check_equal_runs(one, four, 1e-9, depends_on_ranks);
  CHECK(largest(four["fewest particles of a rank"]) == 0.);
}

TEST_CASE("A body crosses the whole box", "[program]")
{
  // It flies from one corner to the other in 300 steps, 50 cells in each direction, through the parts of
  // all ranks. The mesh goes with it: no particle is lost, the work stays shared out, the cells that it
  // leaves are coarsened again, and the run is the same as on one rank.
  const std::string scene = flying_squares(
    "crossing", "flyer", square("flyer", "0.03, 0.03", "0.11, 0.11", "16.667, 16.667"), magnetic);
  const Statistics one   = statistics_on(scene, "crossing", 1);
  const Statistics three = statistics_on(scene, "crossing", 3);
  REQUIRE(one.n_rows() == 301);
  check_equal_runs(one, three, 1e-9, depends_on_ranks);
  CHECK(one.last("centre of mass x [m]") == Approx(0.57).epsilon(1e-3));
  CHECK(one.last("lost particles") == 0.);
  CHECK(three.last("migrated particles") > one.last("particles"));
  CHECK(largest(three["load imbalance [-]"]) < 1.5);
  const auto &unknowns = one["potential unknowns"];
  CHECK(largest(unknowns) < 2. * smallest(unknowns));
  // A change of the mesh serves for two cells at least.
  CHECK(one.last("mesh changes") > 3.);
  CHECK(one.last("mesh changes") < 25.);
}

TEST_CASE("All particles gather in one place", "[program]")
{
  // Four squares fly from the corners of the box into one block in its middle and meet there. What was
  // shared out evenly ends on one rank, which the statistics say; the run is the same as on one rank.
  const std::string bodies = square("a", "0.14, 0.14", "0.16, 0.16", "6.1, 6.2") +
                             square("b", "0.52, 0.14", "0.54, 0.16", "-6, 6") +
                             square("c", "0.14, 0.52", "0.16, 0.54", "6, -6") +
                             square("d", "0.52, 0.52", "0.54, 0.54", "-6, -6");
  const std::string scene = flying_squares("gathering", "a, b, c, d", bodies, elastic);
  const Statistics one    = statistics_on(scene, "gathering", 1);
  const Statistics four   = statistics_on(scene, "gathering", 4);
  REQUIRE(one.n_rows() == 301);
  check_equal_runs(one, four, 1e-9, depends_on_ranks);
  const auto &fewest    = four["fewest particles of a rank"];
  const auto &imbalance = four["load imbalance [-]"];
  CHECK(fewest.front() == 0.25 * one.last("particles"));
  CHECK(imbalance.front() < 1.01);
  CHECK(smallest(fewest) == 0.);
  CHECK(largest(imbalance) > 3.);
  CHECK(four.last("lost particles") == 0.);
}
