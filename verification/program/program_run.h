#pragma once

#include <string>

/** Starting magmpm and other programs. */
namespace magmpm::verification
{
  struct Outcome
  {
    int exit_code;
    std::string output;
    std::string errors;
  };

  /**
   * Runs a shell command in the current directory, where command.sh, output.txt and errors.txt are left.
   * MPI leaves variables in the environment of a program that uses it, which would make a program started
   * from it believe that it is one of its ranks; so only what is needed stays.
   */
  Outcome
  run(const std::string &command);

  /** The shell command that starts magmpm on this many ranks. */
  std::string
  magmpm_command(const std::string &arguments, const int n_ranks = 1);

  /**
   * Runs magmpm on this many ranks; unless it resumes, with --overwrite: what an earlier run of the same
   * test left is in nobody's way.
   */
  Outcome
  run_magmpm(const std::string &arguments, const int n_ranks = 1);

  /** Writes a parameter file NAME.prm whose results go to output-NAME, and returns its name. */
  std::string
  write_scene(const std::string &name, const std::string &text);

  /**
   * Runs magmpm on one rank on a scene; its results go to output-NAME in the current directory.
   *
   * @param text  of the parameter file, without its output directory.
   * @return the output folder.
   * @throw std::runtime_error with what magmpm said if it failed.
   */
  std::string
  run_scene(const std::string &name, const std::string &text);

  /** The shortest text of a number for a parameter file. */
  std::string
  as_text(const double number);
} // namespace magmpm::verification
