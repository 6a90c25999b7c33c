#pragma once

#include <string>

namespace magmpm::benchmarks
{
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
} // namespace magmpm::benchmarks
