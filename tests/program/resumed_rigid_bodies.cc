// Runs with rigid bodies, resumed, and what they say of their outputs.

#include "catch.h"
#include "program/equal_runs.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <algorithm>
#include <filesystem>

using namespace magmpm::testing;
using namespace magmpm::verification;
using Catch::Matchers::Contains;

namespace
{
  /** A pool through which a rigid disc is moved fast, on the right of the box: the second of two ranks
   * sees what the disc pushes out, and the first does not. */
  std::string
  disc_in_pool(const std::string &name)
  {
    ParameterText scene;
    scene.gravity  = "0, -9.81";
    scene.box      = "0.32, 0.16";
    scene.end_time = "0.06";
    scene.add_box("pool", "oil", "0, 0", "0.32, 0.1").add_fluid("oil", "5e4", "1");
    scene.rest =
      "set Checkpoint every = 1 frames\n"
      "subsection Rigid bodies\nset List of rigid bodies = disc\nsubsection disc\n"
      "set Shape = sphere\nset Centre = 0.26, 0.13\nset Radius = 0.025\nset Motion = scripted\n"
      "set Position = 0.26; if(t < 0.02, 0.13 - 3*t, 0.07)\nend\nend\n"
      "subsection Output\nset Frame interval = 0.03\nset Fields = false\n"
      "set Statistics every = 40\nend\n";
    return write_scene(name, scene.text());
  }

  void
  run_to(const std::string &scene,
         const std::string &folder,
         const std::string &arguments,
         const int n_ranks)
  {
    const Outcome outcome =
      run_magmpm(scene + " --set \"Output directory=" + folder + "\" " + arguments, n_ranks);
    INFO(outcome.output << outcome.errors);
    REQUIRE(outcome.exit_code == 0);
  }
} // namespace

TEST_CASE("A resumed run is the straight run, with a row now and then, on several ranks",
          "[program]")
{
  // Between two rows the deepest penetration is that of the rank which saw it. The checkpoint falls
  // between two rows, when the disc has come to rest: the next row has to tell what was before.
  const std::string scene = disc_in_pool("now-and-then");
  for (const std::string folder : {"now-straight", "now-resumed"})
    std::filesystem::remove_all(folder);
  run_to(scene, "now-straight", "", 2);
  run_to(scene, "now-resumed", "--set \"End time=0.03\"", 2);
  run_to(scene, "now-resumed", "--resume", 2);
  const Statistics straight("now-straight");
  check_equal_runs(straight, Statistics("now-resumed"), 1e-12, is_wall_time);
  const auto &depth = straight["deepest penetration [m]"];
  CHECK(*std::max_element(depth.begin(), depth.end()) > 1e-5);
}

TEST_CASE("A run names all that it has written", "[program]")
{
  // At its end, on the terminal and in the log, with surfaces of rigid bodies among them.
  const std::string scene = disc_in_pool("names");
  std::filesystem::remove_all("names");
  run_to(scene, "names", "--set \"End time=0.002\" --set Output/Surface=true", 1);
  const std::string log = contents("names/log.txt");
  const std::string end = log.substr(log.find("results in"));
  for (const auto &entry : std::filesystem::directory_iterator("names"))
    if (entry.path().extension() == ".pvd" || entry.path().extension() == ".csv")
      CHECK_THAT(end, Contains(entry.path().filename().string()));
  CHECK_THAT(end, Contains("rigid_bodies.pvd"));
}
