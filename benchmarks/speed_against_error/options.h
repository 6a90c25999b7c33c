#pragma once

#include <speed_against_error/experiment.h>

#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** What is asked of speed_against_error. */
  struct SpeedOptions
  {
    Medium medium;
    double max_resolution = 16.;  ///< R/dx
    double max_seconds    = 10.;  ///< slower contenders are left out on finer lattices
    double repetitions    = 4.;   ///< at R/dx up to 6; two thirds of these up to 12, half beyond
    double tolerance      = 1e-6; ///< of Newton's method
    double reference      = 24.;  ///< R/dx of the cube that cubes are compared with
    std::string csv_file  = "speed_against_error.csv";
    std::vector<ExperimentKind> experiments = {std::begin(all_experiments),
                                               std::end(all_experiments)};
    bool help                               = false;
  };

  /** @throw InputError  an unknown option, or a value that is none. */
  SpeedOptions
  parse_speed_options(const std::vector<std::string> &arguments);

  /** What --help says. */
  std::string
  speed_usage();
} // namespace magmpm::benchmarks
