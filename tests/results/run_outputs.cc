// What a run leaves in its folder: named at its end, and removed when another begins there.

#include "../test_folder.h"
#include "catch.h"

#include <magmpm/results/run_log.h>
#include <magmpm/results/run_outputs.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace magmpm;

namespace
{
  void
  make_file(const std::string &path)
  {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path) << "x";
  }
} // namespace

TEST_CASE("the log names every output that is there", "[results]")
{
  // Each output brings its own line, so that none is forgotten, as the rigid bodies once were: a run that
  // left all of them names all, and what is not there is not named.
  const std::string folder = testing::fresh_folder("run_outputs-list");
  for (const RunOutput &output : run_outputs())
    make_file(folder + "/" + output.name);
  std::ostringstream terminal;
  RunLog(MPI_COMM_SELF, folder, 1, 1., terminal).end({{"checkpoint", "to go on from"}});

  for (const char *name : {"particles.pvd",
                           "fields.pvd",
                           "surface.pvd",
                           "rigid_bodies.pvd",
                           "statistics.csv",
                           "log.txt",
                           "parameters.prm"})
    {
      INFO(name);
      CHECK(terminal.str().find("\n  " + std::string(name) + " ") != std::string::npos);
    }
  CHECK(terminal.str().find("checkpoint") == std::string::npos);
}

TEST_CASE("frames of an earlier run are removed, and nothing else", "[results]")
{
  // Frames of all kinds and their records go. What no output writes under such a name stays, in the same folders too.
  const std::string folder               = testing::fresh_folder("run_outputs-remove");
  const std::vector<std::string> frames  = {"particles.pvd",
                                            "particles/particles_0000.0.vtu",
                                            "particles/particles_0000.pvtu",
                                            "particles/particles_12345.pvtu",
                                            "fields.pvd",
                                            "fields/fields_0001.0.vtu",
                                            "rigid_bodies.pvd",
                                            "rigid_bodies/rigid_bodies_0001.pvtu",
                                            "surface.pvd",
                                            "surface/surface_0003.vtp"};
  const std::vector<std::string> of_user = {"statistics.csv",
                                            "log.txt",
                                            "my.pvd",
                                            "particles/particles_0000.png",
                                            "particles/fields_0000.pvtu",
                                            "surface/smooth_0003.vtp"};
  for (const auto &files : {frames, of_user})
    for (const std::string &file : files)
      make_file(folder + "/" + file);
  remove_earlier_frames(folder);
  remove_earlier_frames(folder); // where there are none

  for (const std::string &file : frames)
    {
      INFO(file);
      CHECK_FALSE(std::filesystem::exists(folder + "/" + file));
    }
  for (const std::string &file : of_user)
    {
      INFO(file);
      CHECK(std::filesystem::exists(folder + "/" + file));
    }
}
