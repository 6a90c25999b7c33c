// What a run says: the same words on the terminal and in log.txt, from one rank only.

#include <magmpm/base/exceptions.h>
#include <magmpm/base/number_text.h>
#include <magmpm/base/simd.h>
#include <magmpm/base/version.h>
#include <magmpm/parallel/error_report.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/ranks.h>
#include <magmpm/results/run_log.h>

#include "../test_folder.h"
#include "catch.h"

#include <iostream>
#include <sstream>

using namespace magmpm;

namespace
{
  /** The cube of Fig. 7 of Sun et al. 2021 and a drop that is not magnetic. */
  RunLog::Scene
  cube_and_drop()
  {
    RunLog::Body cube;
    cube.name                                       = "cube";
    cube.n_particles                                = 110000;
    cube.density                                    = 2500.;
    cube.material.shear_modulus                     = 4e5;
    cube.material.lame_lambda                       = 5e5;
    cube.material.magnetic.initial_susceptibility   = 0.9123;
    cube.material.magnetic.saturation_magnetization = 8.229e4;

    RunLog::Body drop;
    drop.name                  = "drop";
    drop.n_particles           = 592;
    drop.density               = 1000.;
    drop.material.law          = MechanicalLaw::viscoelastic_fluid;
    drop.material.bulk_modulus = 1e6;
    drop.material.viscosity    = 0.01;

    RunLog::Scene scene;
    scene.lattice_spacing    = 1. / 128.;
    scene.n_particles        = 110592;
    scene.potential_unknowns = 44909;
    scene.memory             = 412e6;
    scene.imbalance          = 1.134;
    scene.bodies             = {cube, drop};
    return scene;
  }
} // namespace

TEST_CASE("numbers are written as people read them", "[results]")
{
  // Thousands, prefixes, short exponents and durations, at the values where their form changes.
  CHECK(with_separators(0) == "0");
  CHECK(with_separators(999) == "999");
  CHECK(with_separators(1000) == "1,000");
  CHECK(with_separators(1234567) == "1,234,567");

  CHECK(three_digits(0.91234) == "0.912");
  CHECK(with_prefix(0.0078125, "m") == "7.81 mm");
  CHECK(with_prefix(8.229e4, "A/m") == "82.3 kA/m");
  CHECK(with_prefix(999.9, "m/s") == "1 km/s");
  CHECK(with_prefix(-0.5, "m/s") == "-500 mm/s");
  CHECK(with_prefix(0., "m/s") == "0 m/s");
  CHECK(with_prefix(3e-15, "m") == "3e-06 nm");

  CHECK(scientific(1.94e-4) == "1.9e-4");
  CHECK(scientific(5e-5) == "5.0e-5");
  CHECK(scientific(12.) == "1.2e1");

  CHECK(duration(0.512) == "0.5 s");
  CHECK(duration(9.96) == "10 s");
  CHECK(duration(59.6) == "1 min 0 s");
  CHECK(duration(90.3) == "1 min 30 s");
  CHECK(duration(3600. * 2 + 60. * 5) == "2 h 5 min");
  CHECK(seconds_from("90 s").value_or(0.) == 90.);
  CHECK(seconds_from("10 min").value_or(0.) == 600.);
  CHECK(seconds_from("1.5 h").value_or(0.) == 5400.);
  for (const char *text : {"", "never", "10", "min", "10 frames", "-3 s", "0 h", "3 s 4", "nan s"})
    CHECK(!seconds_from(text));
}

TEST_CASE("terminal and log.txt hold the same header, from rank 0 alone", "[results][mpi]")
{
  // The header names version, instruction set, lattice, particles, unknowns and each body with its
  // particles and what it is made of. Wave speeds: sqrt((5e5 + 8e5)/2500) = 22.8 m/s and sqrt(1e6/1000) = 31.6 m/s. Where there
  // are several ranks it tells how they share the load, and a line follows when they share it anew.
  const std::string folder = testing::fresh_folder("run_log-header");
  std::ostringstream terminal;
  {
    RunLog log(MPI_COMM_WORLD, folder, 200, 2e-3, terminal);
    log.header(cube_and_drop());
    log.rebalanced(1.5, 1.04);
  }
  if (testing::this_rank() > 0)
    CHECK(terminal.str().empty());
  else
    {
      const unsigned int n_ranks = parallel::n_ranks(MPI_COMM_WORLD);
      const std::string expected =
        "  3D, lattice dx = 7.81 mm, 110,592 particles, 44,909 potential unknowns, 412 MB" +
        std::string(n_ranks > 1 ? ", load imbalance 1.13\n" : "\n") +
        "  cube: 110,000 particles, elastic, wave speed 22.8 m/s; Langevin, chi_0 = 0.912, "
        "saturation 82.3 kA/m\n"
        "  drop: 592 particles, fluid, sound speed 31.6 m/s, viscosity 10 mPa s; not magnetic\n"
        "  load imbalance 1.5 on " +
        std::to_string(n_ranks) + " ranks: cells and particles dealt out anew, now 1.04\n";
      CHECK(terminal.str().find(version_string() + ", " + simd_instruction_set + ", ") == 0);
      CHECK(terminal.str().find(expected) != std::string::npos);
      CHECK(testing::contents(folder + "/log.txt") == terminal.str());
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_CASE("a frame is a line of fixed width", "[results]")
{
  // Percent, t with the digits that tell frames apart, dt and its limit, Newton and CG, speed: the
  // line of the manual. Lines of different frames line up, so that the eye can run down a column.
  const std::string folder = testing::fresh_folder("run_log-frame");
  std::ostringstream terminal;
  RunLog log(MPI_COMM_SELF, folder, 200, 2e-3, terminal);
  log.header(cube_and_drop());
  terminal.str("");
  log.frame({12, 0.024, 1.94e-4, "elastic", 1, 3, 9, 2.1});
  log.frame({113, 0.226, 1.2e-5, "frame end", 2, 4, 112, 0.0213});
  log.frame({114, 0.228, 1.2e-5, "fixed", 0, 0, 0, 0.});

  std::istringstream lines(terminal.str());
  std::string first, line;
  std::getline(lines, first);
  const std::string beginning = "frame  12/200   6 %  t = 0.0240 s  dt = 1.9e-4 s (elastic)    "
                                "Newton  3, CG   9  |v| <    2.1 m/s  ";
  CHECK(first.substr(0, beginning.size()) == beginning);
  CHECK(first.find("s/frame, about") != std::string::npos);
  while (std::getline(lines, line))
    CHECK(line.find("|v| <") == first.find("|v| <"));
}

TEST_CASE("a frame without a magnetic solve does not speak of Newton", "[results]")
{
  // A scene without magnetic material has no solves: the line must not pretend that there are any.
  // After the last frame no time is left.
  const std::string folder = testing::fresh_folder("run_log-no_solve");
  std::ostringstream terminal;
  RunLog log(MPI_COMM_SELF, folder, 2, 2e-3, terminal);
  log.frame({2, 0.004, 1e-4, "fixed", 0, 0, 0, 0.});
  CHECK(terminal.str().find("Newton") == std::string::npos);
  CHECK(terminal.str().find("left") == std::string::npos);
  CHECK(terminal.str().find("frame 2/2 100 %") == 0);
}

TEST_CASE("warnings stand out and failures are kept in log.txt", "[results]")
{
  // A warning is on both; the reason of a failure only in the file, because the main function
  // writes it on standard error.
  const std::string folder = testing::fresh_folder("run_log-warnings");
  std::ostringstream terminal;
  {
    RunLog log(MPI_COMM_SELF, folder, 1, 1., terminal);
    log.warning("3 particles left the box.");
    parallel::FailureLog failures;
    failures.append_to(log.path());
    failures.write("Particle 7 ran away.");
    log.end();
  }
  const std::string file = testing::contents(folder + "/log.txt");
  CHECK(terminal.str().find("WARNING: 3 particles left the box.\n") != std::string::npos);
  CHECK(file.find("WARNING: 3 particles left the box.\n") != std::string::npos);
  CHECK(terminal.str().find("FAILED") == std::string::npos);
  CHECK(file.find("FAILED: Particle 7 ran away.\n") != std::string::npos);

  // Of the results only what exists is named: here log.txt and no frame.
  CHECK(file.find("results in " + folder) != std::string::npos);
  CHECK(file.find("log.txt") != std::string::npos);
  CHECK(file.find("particles.pvd") == std::string::npos);
}

TEST_CASE("the timing table goes to terminal and log.txt", "[results][mpi]")
{
  // All ranks together print the table into the log's stream: one table must come out,
  // on both ends, and none from the ranks that are silent.
  const std::string folder = testing::fresh_folder("run_log-timing");
  std::ostringstream terminal;
  {
    RunLog log(MPI_COMM_WORLD, folder, 1, 1., terminal);
    parallel::PhaseTimer timer;
    {
      const parallel::PhaseTimer::Scope scope(timer, "P2G");
    }
    timer.print(MPI_COMM_WORLD, log.stream());
    log.end();
  }
  if (testing::this_rank() > 0)
    CHECK(terminal.str().empty());
  else
    {
      const std::size_t first = terminal.str().find("P2G");
      CHECK(first != std::string::npos);
      CHECK(terminal.str().find("P2G", first + 1) == std::string::npos);
      CHECK(testing::contents(folder + "/log.txt") == terminal.str());
    }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_CASE("a log that cannot be opened says which and why", "[results]")
{
  // The message names the file and what to look at.
  CHECK_THROWS_WITH(RunLog(MPI_COMM_SELF, "no-such-folder", 1, 1., std::cout),
                    "The log 'no-such-folder/log.txt' cannot be opened for writing. Is there such "
                    "a folder, and are you allowed to write there?");
}
