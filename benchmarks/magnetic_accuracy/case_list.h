#pragma once

#include <verification/magnetostatics/accuracy_case.h>

#include <functional>
#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** Cases that differ in resolution and offset alone. */
  struct CaseSeries
  {
    struct Resolution
    {
      double value; ///< R/dx
      unsigned int n_offsets;
    };

    std::string group;
    std::string variant;
    std::vector<Resolution> resolutions;
    verification::AccuracyCase accuracy_case; ///< what it is apart from resolution and offset
    std::function<verification::Errors(const verification::AccuracyCase &)> measure;
    bool fits_orders = false; ///< the resolutions are those of one body
  };

  /**
   * Everything that magnetic_accuracy measures in @p dim dimensions.
   *
   * @param standard  indicator, edge of cells and communicator of all cases that say nothing else.
   */
  template <int dim>
  std::vector<CaseSeries>
  all_cases(const verification::AccuracyCase &standard);

  /** The groups of all_cases(), in their order. */
  std::vector<std::string>
  case_groups();
} // namespace magmpm::benchmarks
