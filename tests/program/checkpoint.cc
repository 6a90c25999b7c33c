#include "catch.h"
#include "program/equal_runs.h"

#include <verification/program/paths.h>
#include <verification/program/program_run.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <chrono>
#include <filesystem>
#include <random>

using namespace magmpm::testing;
using namespace magmpm::verification;

namespace
{
  /** A soft magnetic disc and a drop, over a magnet that moves to and fro: everything that is carried along. */
  std::string
  disc_and_drop(const std::string &name)
  {
    return write_scene(name, R"(
set Dimension = 2
set End time  = 0.08
set Gravity   = 0, -9.81
set Checkpoint every = 2 frames
subsection Box
  set Upper corner = 0.32, 0.32
  set Cell size    = 0.01
end
subsection Bodies
  set List of bodies = disc, drop
  subsection disc
    set Material = rubber
    set Shape    = sphere
    set Centre   = 0.12, 0.2
    set Radius   = 0.05
    set Density  = 1000
    set Velocity = 0.5, -1
    set Angular velocity = 10
    set Contact group = 1
  end
  subsection drop
    set Material = water
    set Shape    = sphere
    set Centre   = 0.24, 0.2
    set Radius   = 0.03
    set Density  = 1000
    set Velocity = -0.5, -1.5
  end
end
subsection Materials
  set List of materials = rubber, water
  subsection rubber
    set Mechanical law           = neo-Hookean
    set Young's modulus          = 1e5
    set Poisson ratio            = 0.3
    set Saturation magnetization = 8e4
    set Initial susceptibility   = 0.9
  end
  subsection water
    set Mechanical law = viscoelastic fluid
    set Bulk modulus   = 1e5
    set Viscosity      = 0.5
  end
end
subsection Magnets
  set List of magnets = ball
  subsection ball
    set Type          = magnetized sphere
    set Position      = 0.16 + 0.05*sin(30*t); 0.06
    set Radius        = 0.04
    set Magnetization = 0; 5e5
    set Contact       = separate
  end
end
subsection Magnetics
  set Magnetization law = Langevin
  set Newton tolerance  = 1e-13
end
subsection Output
  set Frame interval = 0.01
  set Surface        = true
end
)");
  }

  std::string
  in_folder(const std::string &folder)
  {
    return " --set \"Output directory=" + folder + "\" ";
  }

  /** Frames that a .pvd file names. */
  std::size_t
  n_frames(const std::string &pvd)
  {
    const std::string text = contents(pvd), frame = "<DataSet ";
    std::size_t n = 0;
    for (std::size_t at = text.find(frame); at != std::string::npos; at = text.find(frame, at + 1))
      ++n;
    return n;
  }

  /** Everything there once, and equal to the straight run. */
  template <typename Predicate>
  void
  check_complete(const std::string &folder,
                 const std::string &straight,
                 const double tolerance,
                 const Predicate &ignores)
  {
    INFO(folder);
    check_equal_runs(Statistics(straight), Statistics(folder), tolerance, ignores);
    for (const std::string record : {"/particles.pvd", "/fields.pvd", "/surface.pvd"})
      CHECK(n_frames(folder + record) == n_frames(straight + record));
  }

  /** The step of the checkpoint that a run would resume from; -1 if there is none. */
  int
  latest_step(const std::string &folder)
  {
    const std::string latest = contents(folder + "/checkpoint/latest");
    return latest.empty() ? -1 : std::stoi(latest.substr(latest.find('-') + 1));
  }

  void
  require_success(const Outcome &outcome)
  {
    INFO(outcome.output << outcome.errors);
    REQUIRE(outcome.exit_code == 0);
  }
} // namespace

TEST_CASE("A resumed run is the straight run", "[program]")
{
  // The straight run writes a checkpoint every second frame, and is brought to the state that can be
  // resumed from at each. So a run that ends at one of them and is resumed, and once more, does the same
  // to rounding on the same ranks, to 1e-9 (Newton converged to 1e-13) on others.
  const std::string scene = disc_and_drop("resume");
  require_success(run_magmpm(scene + in_folder("straight")));
  CHECK(n_frames("straight/particles.pvd") == 9);
  CHECK(n_frames("straight/surface.pvd") == 9);

  const auto run_in_parts = [&](const std::string &folder, const std::vector<int> &ranks) {
    const std::vector<std::string> ends = {"0.02", "0.06", "0.08"};
    for (std::size_t part = 0; part < ends.size(); ++part)
      require_success(run_magmpm((part > 0 ? "--resume " : "") + scene + in_folder(folder) +
                                   "--set \"End time=" + ends[part] + "\"",
                                 ranks[part]));
  };
  run_in_parts("same-ranks", {1, 1, 1});
  check_complete("same-ranks", "straight", 1e-12, is_wall_time);
  run_in_parts("other-ranks", {2, 1, 3});
  // At the edge of the tolerance, rounding decides whether Newton does one step more.
  check_complete("other-ranks", "straight", 1e-9, [](const std::string &heading) {
    return depends_on_ranks(heading) || heading == "Newton steps";
  });
}

TEST_CASE("A killed run loses nothing past its checkpoint", "[program]")
{
  // SIGKILL at 20 random moments, also while a checkpoint, a frame or a row is being written, or when
  // a frame and rows were written after the last checkpoint. Each time the run goes on from the latest
  // checkpoint, which is never older than the one before, and in the end there is what the straight run
  // wrote: no row or frame twice, none missing.
  const std::string scene = disc_and_drop("killed");
  const auto start        = std::chrono::steady_clock::now();
  require_success(run_magmpm(scene + in_folder("not-killed")));
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  std::filesystem::remove_all("killed");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> moment(0.3 * seconds, 0.9 * seconds);
  int n_killed = 0, n_resumed = 0, latest = -1;
  for (bool is_complete = false; n_killed < 20 || !is_complete;)
    {
      const std::string limit = n_killed < 20
                                  ? "timeout -s KILL " + std::to_string(moment(random)) + " "
                                  : "";
      n_resumed += (latest >= 0);
      const Outcome outcome = run(limit + magmpm_program() + (latest >= 0 ? " --resume " : " ") +
                                  scene + in_folder("killed"));
      INFO(outcome.output << outcome.errors);
      is_complete = (outcome.exit_code == 0);
      if (is_complete)
        {
          check_complete("killed", "not-killed", 1e-12, is_wall_time);
          latest = -1; // from the start again, until it was killed often enough
          std::filesystem::remove_all("killed");
          continue;
        }
      REQUIRE(outcome.exit_code == 137);
      ++n_killed;
      const int step = latest_step("killed");
      CHECK(step >= latest);
      latest = step;
    }
  CHECK(n_resumed >= 5);
}

TEST_CASE("A run that is asked to stop writes a checkpoint", "[program]")
{
  // Signals, a file and the wall time end a run after its step, with exit code 0 and a checkpoint at
  // that step; resumed, it comes to the end with every row there once.
  const std::string scene = disc_and_drop("stopped") +
                            " --set \"Checkpoint every=never\" --set Output/Fields=false ";
  const std::string folder = "stopped";
  std::string command, reason;
  const std::string start = magmpm_program() + " " + scene + in_folder(folder);
  const std::string wait  = "until [ -s stopped/particles.pvd ]; do sleep 0.02; done; ";
  SECTION("SIGTERM")
  {
    command = start + "& " + wait + "kill -TERM $!; wait $!";
    reason  = "stopped by SIGTERM or SIGUSR1";
  }
  SECTION("SIGINT, as Ctrl-C sends it")
  {
    // A shell lets what it starts in the background ignore it; env undoes that.
    command = "env --default-signal=INT " + start + "& " + wait + "kill -INT $!; wait $!";
    reason  = "stopped by Ctrl-C";
  }
  SECTION("SIGUSR1, through mpirun")
  {
    command = mpiexec() + " -n 2 " + start + "& " + wait + "kill -USR1 $!; wait $!";
    reason  = "stopped by SIGTERM or SIGUSR1";
  }
  SECTION("the file")
  {
    command = start + "& " + wait + "touch stopped/stop; wait $!";
    reason  = "stopped by the file 'stop'";
  }
  SECTION("the wall time")
  {
    command = start + "--set \"End wall time=0.01 s\"";
    reason  = "stopped by End wall time";
  }
  std::filesystem::remove_all(folder);
  const Outcome stopped = run(command);
  require_success(stopped);
  CHECK_THAT(stopped.output, Catch::Matchers::Contains(reason));
  CHECK(!std::filesystem::exists(folder + "/stop"));
  const Statistics part(folder);
  CHECK(part.last("time [s]") < 0.08);
  CHECK(latest_step(folder) == part.last("step"));

  require_success(run_magmpm("--resume " + scene + in_folder(folder)));
  const Statistics whole(folder);
  CHECK(whole.last("time [s]") == Approx(0.08));
  for (std::size_t row = 0; row < whole.n_rows(); ++row)
    REQUIRE(whole["step"][row] == row);
  CHECK(n_frames(folder + "/particles.pvd") == 9);
}

// No checkpoint, other parameters, and one that was cut, changed or lost: each is refused in its
// own words, and when the bytes are those written again, the run goes on.
TEST_CASE("A run cannot be resumed from what does not fit", "[program]")
{
  const std::string scene = disc_and_drop("unfit") + in_folder("unfit");
  const auto resume       = [&](const std::string &change) {
    const Outcome outcome = run_magmpm("--resume " + scene + change);
    return std::to_string(outcome.exit_code) + ": " + outcome.errors;
  };
  using Catch::Matchers::Contains;
  std::filesystem::remove_all("unfit");
  CHECK_THAT(resume(""),
             Contains("2: ") && Contains("there is nothing to resume") &&
               Contains("'unfit/checkpoint/latest' does not exist"));

  require_success(run_magmpm(scene + "--set \"End time=0.02\""));
  CHECK_THAT(resume("--set \"Bodies/disc/Density=900\" --set \"Box/Cell size=0.02\""),
             Contains("2: ") && Contains("Bodies/disc/Density = 900, was 1000") &&
               Contains("Box/Cell size = 0.02, was 0.01") && Contains("without --resume"));

  const std::string file      = "unfit/" + contents("unfit/checkpoint/latest");
  const std::string particles = "unfit/checkpoint/" + file.substr(6, file.find('\n') - 6) +
                                "/particles-00000.bin";
  const std::string bytes = contents(particles);
  const auto write        = [&](const std::string &text) {
    std::ofstream(particles, std::ios::binary) << text;
  };
  write(bytes.substr(0, bytes.size() - 8));
  CHECK_THAT(resume(""),
             Contains("1: ") && Contains("particles-00000.bin' is cut off") &&
               Contains("write the name of another one into"));
  std::string damaged = bytes;
  damaged[bytes.size() / 2] ^= 1;
  write(damaged);
  CHECK_THAT(resume(""), Contains("1: ") && Contains("particles-00000.bin' is damaged"));
  std::filesystem::remove(particles);
  CHECK_THAT(resume(""), Contains("1: ") && Contains("particles-00000.bin' is missing"));
  write(bytes);
  require_success(run_magmpm("--resume " + scene + "--set \"End time=0.03\""));
}
