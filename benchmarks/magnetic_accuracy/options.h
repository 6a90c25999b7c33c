#pragma once

#include <magmpm/magnetics/magnetics_parameters.h>

#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** What is asked of magnetic_accuracy. */
  struct Options
  {
    std::vector<std::string> groups; ///< of cases; empty: all
    std::vector<int> dimensions = {3, 2};
    double max_resolution       = 16.; ///< R/dx
    unsigned int max_offsets    = 8;
    MaterialIndicator indicator = MaterialIndicator::sharp;
    int cell_edge               = 2;
    bool csv                    = false;
    bool check                  = false; ///< a missed limit is a failure
    bool help                   = false;

    bool
    wants(const std::string &group) const;
  };

  /**
   * @param arguments    those behind the name of the program.
   * @param groups       all there are.
   * @throw InputError   an unknown option or group, or a value that is none.
   */
  Options
  parse_options(const std::vector<std::string> &arguments, const std::vector<std::string> &groups);

  /** What --help says. */
  std::string
  usage(const std::vector<std::string> &groups);
} // namespace magmpm::benchmarks
