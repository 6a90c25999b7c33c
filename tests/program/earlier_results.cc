// What lies in the output directory already is not lost: results of an earlier run, of a run that is
// resumed, of one that is still at work.

#include "catch.h"
#include "program/equal_runs.h"
#include "program/folder_contents.h"
#include "program/parameter_text.h"

#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace magmpm::testing;
using namespace magmpm::verification;
using Catch::Matchers::Contains;

namespace
{
  /** A rubber square that falls: a frame each 10 ms, a checkpoint each second frame and at the end. */
  std::string
  falling_square(const std::string &name, const std::string &lines = "")
  {
    ParameterText scene;
    scene.gravity  = "0, -9.81";
    scene.end_time = "0.05";
    scene.add_box("square", "rubber", "0.1, 0.1", "0.2, 0.2").add_solid("rubber", "1e5");
    scene.rest = "set Checkpoint every = 2 frames\nsubsection Output\nset Frame interval = 0.01\n"
                 "set Surface = true\nend\n" +
                 lines;
    std::filesystem::remove_all("output-" + name);
    return write_scene(name, scene.text());
  }

  void
  require_success(const Outcome &outcome)
  {
    INFO(outcome.output << outcome.errors);
    REQUIRE(outcome.exit_code == 0);
  }

  /** How many frames of particles lie in a folder, whether a .pvd names them or not. */
  std::size_t
  n_frame_files(const std::string &folder)
  {
    std::size_t n = 0;
    for (const auto &[name, bytes] : folder_contents(folder))
      n += (name.rfind("particles/", 0) == 0 && name.find(".vtu") != std::string::npos);
    return n;
  }

  /** The folder of the checkpoint that a run would be resumed from. */
  std::string
  latest_checkpoint(const std::string &folder)
  {
    const std::string name = contents(folder + "/checkpoint/latest");
    return folder + "/checkpoint/" + name.substr(0, name.find('\n'));
  }

  /** Lets latest name the first of the checkpoints, as after a kill between the first and the second. */
  void
  go_back_to_first_checkpoint(const std::string &folder)
  {
    std::string first;
    for (const auto &entry : std::filesystem::directory_iterator(folder + "/checkpoint"))
      if (entry.is_directory() && (first.empty() || entry.path().filename() < first))
        first = entry.path().filename();
    std::ofstream(folder + "/checkpoint/latest") << first << '\n';
  }

  /** Checks that magmpm refuses to start, with all texts, and leaves the folder to the byte as it was. */
  void
  check_refused(const std::string &arguments,
                const std::string &folder,
                const int exit_code,
                const std::vector<std::string> &texts,
                const int n_ranks = 1)
  {
    INFO(arguments << " on " << n_ranks << " ranks");
    const auto before     = folder_contents(folder);
    const Outcome outcome = run(magmpm_command(arguments, n_ranks));
    CHECK(outcome.exit_code == exit_code);
    for (const std::string &text : texts)
      CHECK_THAT(outcome.errors, Contains(text));
    CHECK(changed_files(before, folder_contents(folder)) == "");
  }
} // namespace

TEST_CASE("A refused --resume leaves the output directory as it was", "[program]")
{
  // Rows, frames and checkpoints from after the checkpoint that would be resumed from: a refusal, for
  // what the scene says or for what lies in the checkpoint, must not take any of them back, nor write
  // the parameters of the refused run over those of the run whose results are there.
  const std::string scene = falling_square("refused"), folder = "output-refused";
  require_success(run(magmpm_command(scene)));
  go_back_to_first_checkpoint(folder);

  const std::string density = "--resume " + scene + " --set Bodies/square/Density=900";
  check_refused(density, folder, 2, {"Bodies/square/Density = 900, was 1000"});
  check_refused(density, folder, 2, {"Bodies/square/Density = 900, was 1000"}, 2);

  const std::string path  = latest_checkpoint(folder) + "/run.bin";
  const std::string bytes = contents(path);
  std::string damaged     = bytes;
  damaged[bytes.size() / 2] ^= 1;
  std::ofstream(path, std::ios::binary) << damaged;
  check_refused("--resume " + scene, folder, 1, {"damaged"});

  // It was fit to be resumed all the time.
  std::ofstream(path, std::ios::binary) << bytes;
  require_success(run(magmpm_command("--resume " + scene)));
  CHECK(Statistics(folder).last("time [s]") == Approx(0.05));
}

TEST_CASE("A checkpoint of another version is refused by its number", "[program]")
{
  // The number that each file begins with, one less or more: written by an older or a newer magmpm, it
  // would be unpacked into the wrong members. The files are whole otherwise, and their sums right.
  const std::string scene = falling_square("versions"), folder = "output-versions";
  require_success(run(magmpm_command(scene)));
  const std::string title = "magmpm checkpoint ";
  for (const char *name : {"/run.bin", "/particles-00000.bin"})
    {
      const std::string path = latest_checkpoint(folder) + name, bytes = contents(path);
      REQUIRE(bytes.compare(0, title.size(), title) == 0);
      const int version = bytes[title.size()] - '0';
      for (const int other : {version - 1, version + 1})
        {
          std::string changed   = bytes;
          changed[title.size()] = static_cast<char>('0' + other);
          std::ofstream(path, std::ios::binary) << changed;
          check_refused("--resume " + scene,
                        folder,
                        1,
                        {"version " + std::to_string(other), "version " + std::to_string(version)});
        }
      std::ofstream(path, std::ios::binary) << bytes;
    }
}

TEST_CASE("A run does not start over an earlier one without a word", "[program]")
{
  // A checkpoint of an earlier run is worth the time of that run: a forgotten --resume, on one rank or
  // more, is refused, and the message names the ways out. Each of them works.
  const std::string scene = falling_square("earlier"), folder = "output-earlier";
  require_success(run(magmpm_command(scene + " --set \"End time=0.03\"")));
  for (const int n_ranks : {1, 2})
    check_refused(scene, folder, 2, {"--resume", "Output directory", "--overwrite"}, n_ranks);

  SECTION("--resume goes on")
  {
    require_success(run(magmpm_command("--resume " + scene)));
    CHECK(Statistics(folder).last("time [s]") == Approx(0.05));
    CHECK(n_frame_files(folder) == 6);
  }
  SECTION("another directory")
  {
    std::filesystem::remove_all("output-elsewhere");
    const auto before = folder_contents(folder);
    require_success(run(magmpm_command(scene + " --set \"Output directory=output-elsewhere\"")));
    CHECK(changed_files(before, folder_contents(folder)) == "");
  }
  SECTION("--overwrite starts anew")
  {
    // Shorter than before: neither frames nor checkpoints nor rows of the earlier run are left.
    require_success(run(magmpm_command("--overwrite " + scene + " --set \"End time=0.01\"")));
    CHECK(Statistics(folder).last("time [s]") == Approx(0.01));
    CHECK(n_frame_files(folder) == 2);
    std::size_t n_checkpoints = 0;
    for (const auto &entry : std::filesystem::directory_iterator(folder + "/checkpoint"))
      n_checkpoints += entry.is_directory();
    CHECK(n_checkpoints == 1);
    for (const auto &[name, bytes] : folder_contents(folder))
      CHECK(name.find("_0002") == std::string::npos);
  }
}

TEST_CASE("Frames of an earlier run do not stay beside those of a new one", "[program]")
{
  // Without a checkpoint results can be had again, and are replaced; a shorter run leaves no frame that
  // its own .pvd does not name, of particles or of surfaces.
  const std::string scene  = falling_square("replaced") + " --set \"Checkpoint every=never\"";
  const std::string folder = "output-replaced";
  require_success(run(magmpm_command(scene)));
  REQUIRE(n_frame_files(folder) == 6);
  require_success(run(magmpm_command(scene + " --set \"End time=0.02\"")));
  CHECK(n_frame_files(folder) == 3);
  for (const auto &[name, bytes] : folder_contents(folder))
    CHECK(name.find("_0003") == std::string::npos);
}

TEST_CASE("Two runs do not write into one folder", "[program]")
{
  // The first one, which would take minutes, holds the folder; the second, resumed or not, on one rank
  // or two, is refused and takes nothing from the first. A kill frees the folder at once: then it goes
  // on, one step, with all rows there once.
  const std::string folder = "output-two-runs";
  const std::string scene  = falling_square("two-runs") + " --set \"Checkpoint every=1 frames\" ";
  const auto second        = [&](const std::string &arguments, const int n_ranks = 1) {
    return magmpm_command(arguments + scene, n_ranks) + "; echo exit code $?; ";
  };
  const Outcome outcome =
    run(magmpm_command(scene + "--set \"End time=100\"") + " >first.txt 2>&1 & first=$!; " +
        "until [ -s " + folder + "/checkpoint/latest ]; do sleep 0.02; done; " + second("") +
        second("--resume ") + second("--overwrite ") + second("--resume ", 2) +
        "kill -0 $first && echo alive; kill -KILL $first; wait $first; echo killed $?; " +
        second("--set \"End wall time=0.01 s\" --resume --set \"End time=100\" >third.txt "));
  INFO(outcome.output << outcome.errors);
  CHECK_THAT(outcome.output,
             Contains("exit code 2\nexit code 2\nexit code 2\nexit code 2\nalive\nkilled 137\n"
                      "exit code 0"));
  CHECK_THAT(outcome.errors, Contains(folder) && Contains("another run"));
  const Statistics statistics(folder);
  for (std::size_t row = 0; row < statistics.n_rows(); ++row)
    REQUIRE(statistics["step"][row] == row);
}
