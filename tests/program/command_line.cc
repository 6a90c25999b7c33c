// What the program answers on its command line: text, exit code, and on which stream. Scripts rely on
// these, and a user who gets them wrong must be told on one line what to write instead.

#include "../catch.h"

#include <verification/program/paths.h>
#include <verification/program/program_run.h>
#include <verification/text_file.h>

#include <filesystem>

using namespace magmpm::verification;

namespace
{
  const std::string files = source_folder() + "/parameter_files/";
} // namespace

// Every file that comes with the program is accepted, with one line and nothing on standard error.
TEST_CASE("--validate accepts all parameter files", "[program]")
{
  for (const auto &file : std::filesystem::directory_iterator(files))
    if (file.path().extension() == ".prm")
      {
        const std::string path = file.path().string();
        const Outcome outcome  = run_magmpm("--validate " + path);
        CHECK(outcome.exit_code == 0);
        CHECK(outcome.output == path + ": valid\n");
        CHECK(outcome.errors == "");
      }
}

// Wrong input ends with exit code 2 and one line on standard error, whatever is wrong; the wording of
// the messages on parameters is tested in tests/parameters/parameter_errors.cc.
TEST_CASE("Wrong input ends with exit code 2 and one line", "[program]")
{
  const auto refused = [](const std::string &arguments, const std::string &message) {
    const Outcome outcome = run_magmpm(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.output == "");
    CHECK(outcome.errors == "magmpm: " + message + "\n");
  };
  refused("", "no parameter file is given. Write 'magmpm FILE.prm'; 'magmpm --help' tells more.");
  refused("--validat",
          "unknown option '--validat'; did you mean '--validate'? 'magmpm --help' lists all "
          "options.");
  refused(
    "a.prm b.prm",
    "there are two parameter files, 'a.prm' and 'b.prm', but a run takes one. If the second is "
    "a value, put it in quotes: --set \"Section/Name=value\".");
  refused("a.prm --set", "nothing follows --set; write --set \"Section/Name=value\".");
  refused("missing.prm",
          "cannot read the parameter file 'missing.prm': No such file or directory.");
  refused(
    files + "drop_2d.prm --set 'Bodies/drop/Densty=1'",
    "--set \"Bodies/drop/Densty=1\": there is no parameter 'Densty' in subsection Bodies/drop; "
    "did you mean 'Density'?");
}

// On several ranks the same message is heard once, and mpirun passes the exit code on.
TEST_CASE("On several ranks wrong input is told once", "[program]")
{
  const Outcome outcome = run_magmpm("--validate missing.prm", 3);
  CHECK(outcome.exit_code == 2);
  const std::string message = "magmpm: cannot read the parameter file 'missing.prm'";
  const std::size_t first   = outcome.errors.find(message);
  REQUIRE(first != std::string::npos);
  CHECK(outcome.errors.find(message, first + 1) == std::string::npos);
}

// One rank is started with a wrong command line, and the other one waits for it to take part in the
// run. Instead of waiting for ever, all must end with the exit code of the rank that failed.
TEST_CASE("A rank that fails alone ends the run", "[program]")
{
  const Outcome outcome = run("timeout 60 " + mpiexec() + " -n 1 " + magmpm_program() + " " +
                              files +
                              "falling_block.prm --set 'Output directory=output-alone' : -n 1 " +
                              magmpm_program() + " --wrong");
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors.find("magmpm: rank 1: unknown option '--wrong'.") != std::string::npos);
}

// The answers to questions go to standard output, and no scene is needed for them.
TEST_CASE("Questions to the program", "[program]")
{
  const Outcome version = run_magmpm("--version");
  CHECK(version.exit_code == 0);
  CHECK(version.output.rfind("magmpm ", 0) == 0);
  CHECK(version.output.find('\n') == version.output.size() - 1);

  const Outcome help = run_magmpm("--help");
  CHECK(help.exit_code == 0);
  CHECK(help.output.rfind(
          "magmpm FILE.prm [--resume] [--set \"Section/Name=value\"]... [--validate]", 0) == 0);

  const Outcome parameters = run_magmpm("--print-parameters");
  CHECK(parameters.exit_code == 0);
  CHECK(parameters.output == contents(source_folder() + "/doc/parameters.md"));
}
