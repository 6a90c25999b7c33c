#include <verification/program/program_run.h>
#include <verification/text_file.h>

#include <verification/program/paths.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace magmpm::verification
{
  Outcome
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

  std::string
  magmpm_command(const std::string &arguments, const int n_ranks)
  {
    const std::string launcher = n_ranks == 1 ? ""
                                              : mpiexec() + " -n " + std::to_string(n_ranks) + " ";
    return launcher + magmpm_program() + " " + arguments;
  }

  Outcome
  run_magmpm(const std::string &arguments, const int n_ranks)
  {
    const bool resumes = arguments.find("--resume") != std::string::npos;
    return run(magmpm_command((resumes ? "" : "--overwrite ") + arguments, n_ranks));
  }

  std::string
  write_scene(const std::string &name, const std::string &text)
  {
    std::ofstream(name + ".prm") << text << "set Output directory = output-" << name << '\n';
    return name + ".prm";
  }

  std::string
  run_scene(const std::string &name, const std::string &text)
  {
    const Outcome run = run_magmpm(write_scene(name, text));
    if (run.exit_code != 0)
      throw std::runtime_error("The scene '" + name + "' failed: " + run.errors);
    return "output-" + name;
  }

  std::string
  as_text(const double number)
  {
    std::ostringstream text;
    text.precision(15);
    text << number;
    return text.str();
  }
} // namespace magmpm::verification
