// Every scene that comes with magmpm is run as it is for two short steps, on two ranks, with output
// before and after. A file that is valid can still not run: a mesh that is missing, a body in a magnet,
// a potential that cannot be solved.

#include "catch.h"

#include <verification/program/paths.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace magmpm::verification;

namespace
{
  std::vector<std::filesystem::path>
  parameter_files()
  {
    std::vector<std::filesystem::path> files;
    for (const auto &file :
         std::filesystem::directory_iterator(source_folder() + "/parameter_files"))
      if (file.path().extension() == ".prm")
        files.push_back(file.path());
    std::sort(files.begin(), files.end());
    return files;
  }
} // namespace

// Two steps of 1e-6 s end at 2e-6 s, and statistics have three rows: the start and both steps.
TEST_CASE("Every parameter file runs for two steps", "[parameter_files]")
{
  for (const std::filesystem::path &file : parameter_files())
    DYNAMIC_SECTION(file.filename().string())
    {
      const std::string folder = "output-two_steps-" + file.stem().string();
      const Outcome outcome =
        run_magmpm(file.string() + " --set 'Output directory=" + folder +
                     "' --set 'Time step/Time step=1e-6' --set 'End time=2e-6'"
                     " --set 'Output/Frame interval=2e-6' --set 'Output/Statistics every=1'"
                     " --set 'Checkpoint every=never'",
                   2);
      CHECK(outcome.errors == "");
      REQUIRE(outcome.exit_code == 0);

      const Statistics statistics(folder);
      REQUIRE(statistics.n_rows() == 3);
      CHECK(statistics.last("step") == 2.);
      CHECK(statistics.last("time [s]") == Approx(2e-6));
      CHECK(statistics.last("particles") >= 100.);
      CHECK(statistics.last("lost particles") == 0.);
      CHECK(std::isfinite(statistics.last("max |v| [m/s]")));
      std::filesystem::remove_all(folder);
    }
}
