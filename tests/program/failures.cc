// What a run leaves behind that fails.

#include "catch.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <filesystem>

using namespace magmpm::testing;
using namespace magmpm::verification;
using Catch::Matchers::Contains;

namespace
{
  /** Two soft magnetic squares, at the left and at the right, of which one flies into the core of a
   * dipole above it, which ends the run. */
  std::string
  square_into_core(const std::string &name, const bool right_one_flies)
  {
    const std::string flight = "set Velocity = 0, 2";
    ParameterText scene;
    scene.add_box("left", "rubber", "0.04, 0.06", "0.12, 0.14", right_one_flies ? "" : flight)
      .add_box("right", "rubber", "0.2, 0.06", "0.28, 0.14", right_one_flies ? flight : "")
      .add_solid(
        "rubber", "1e5", "set Saturation magnetization = 1e4\nset Initial susceptibility = 1\n");
    scene.rest = "set Checkpoint every = never\nsubsection Magnets\nset List of magnets = speck\n"
                 "subsection speck\nset Type = point dipole\nset Position = " +
                 std::string(right_one_flies ? "0.24" : "0.08") +
                 "; 0.2\nset Moment = 0; 1\nset Radius = 0.004\nend\nend\n"
                 "subsection Output\nset Frame interval = 1\nend\n";
    std::filesystem::remove_all("output-" + name);
    return write_scene(name, scene.text());
  }
} // namespace

TEST_CASE("A failure on any rank stands in the log, with all rows up to it", "[program]")
{
  // Of two ranks the one holds the square that flies into the core, and it alone finds out; which one
  // that is does the side of the box decide. The rows since the last frame (there is none but the
  // first) are those of the run on one rank, which fails in the same step.
  for (const bool right_one_flies : {false, true})
    {
      const std::string name  = right_one_flies ? "core-right" : "core-left";
      const std::string scene = square_into_core(name, right_one_flies);
      const Outcome one       = run_magmpm(scene);
      INFO(name << ": " << one.output << one.errors);
      REQUIRE(one.exit_code == 1);
      REQUIRE_THAT(one.errors, Contains("core"));
      const std::string folder     = "output-" + name;
      const std::size_t n_rows     = Statistics(folder).n_rows();
      const double last_step       = Statistics(folder).last("step");
      const std::string log_of_one = contents(folder + "/log.txt");
      REQUIRE(n_rows > 10);
      CHECK_THAT(log_of_one, Contains("FAILED: ") && Contains("core"));

      std::filesystem::remove_all(folder);
      const Outcome two = run_magmpm(scene, 2);
      CHECK(two.exit_code == 1);
      CHECK_THAT(two.errors, Contains("core"));
      CHECK_THAT(contents(folder + "/log.txt"), Contains("FAILED: ") && Contains("core"));
      REQUIRE(std::filesystem::exists(folder + "/statistics.csv"));
      const Statistics statistics(folder);
      CHECK(statistics.n_rows() == n_rows);
      CHECK(statistics.last("step") == last_step);
    }
}
