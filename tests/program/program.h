#pragma once

#include <program/paths.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

/** Starting magmpm and other programs from a test. */
namespace magmpm::testing
{
  struct Outcome
  {
    int exit_code;
    std::string output;
    std::string errors;
  };

  inline std::string
  contents(const std::string &path)
  {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  /**
   * Runs a shell command. MPI leaves variables in the environment of the test program, which would
   * make a program started from it believe that it is one of its ranks; so only what is needed stays.
   */
  inline Outcome
  run(const std::string &command)
  {
    std::string environment = "env -i";
    for (const char *name : {"PATH",
                             "HOME",
                             "TMPDIR",
                             "LD_LIBRARY_PATH",
                             "OMP_NUM_THREADS",
                             "OMPI_ALLOW_RUN_AS_ROOT",
                             "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                             "OMPI_MCA_rmaps_base_oversubscribe",
                             "ASAN_OPTIONS",
                             "LSAN_OPTIONS",
                             "UBSAN_OPTIONS"})
      if (const char *value = std::getenv(name))
        environment += " " + std::string(name) + "='" + value + "'";

    std::ofstream("command.sh") << command << '\n';
    const int status =
      std::system((environment + " sh command.sh > output.txt 2> errors.txt").c_str());
    return {WEXITSTATUS(status), contents("output.txt"), contents("errors.txt")};
  }

  /** Runs magmpm on this many ranks. */
  inline Outcome
  run_magmpm(const std::string &arguments, const int n_ranks = 1)
  {
    const std::string launcher =
      n_ranks == 1 ? "" : mpiexec() + " -n " + std::to_string(n_ranks) + " ";
    return run(launcher + magmpm_program() + " " + arguments);
  }
} // namespace magmpm::testing
