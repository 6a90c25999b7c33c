#pragma once

#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** What is asked of particle_step. */
  struct StepOptions
  {
    std::vector<double> particles = {110592.}; ///< about how many, one run each
    int repeats                   = 10;
    int steps                     = 40; ///< of a repeat, between two sorts
    bool help                     = false;
  };

  /** @throw InputError  an unknown option, or a value that is none. */
  StepOptions
  parse_step_options(const std::vector<std::string> &arguments);

  /** What --help says. */
  std::string
  step_usage();
} // namespace magmpm::benchmarks
