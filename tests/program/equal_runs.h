#pragma once

#include "catch.h"

#include <verification/program/statistics.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace magmpm::testing
{
  /** The columns of a vector are compared with its largest component: "momentum x" with "momentum". */
  inline std::string
  group_of(const std::string &heading)
  {
    for (const std::string axis : {" x [", " y [", " z ["})
      {
        const auto place = heading.find(axis);
        if (place != std::string::npos)
          return heading.substr(0, place);
      }
    return heading;
  }

  inline bool
  is_wall_time(const std::string &heading)
  {
    return heading.find("wall time") != std::string::npos;
  }

  /** What the number of ranks may change: a last Newton step that only rounds is one more or less. */
  inline bool
  depends_on_ranks(const std::string &heading)
  {
    return is_wall_time(heading) || heading == "migrated particles" ||
           heading == "fewest particles of a rank" || heading == "load imbalance [-]" ||
           heading == "mesh changes" || heading == "Newton steps" || heading == "CG iterations" ||
           heading.find("Newton residual") != std::string::npos;
  }

  /**
   * Checks that two runs wrote the same rows, and that all columns agree.
   *
   * @param tolerance  relative to the largest value of a column in @p one.
   * @param ignores    bool(heading): columns that may differ.
   */
  template <typename Predicate>
  void
  check_equal_runs(const verification::Statistics &one,
                   const verification::Statistics &other,
                   const double tolerance,
                   const Predicate &ignores)
  {
    REQUIRE(other.headings == one.headings);
    REQUIRE(other.n_rows() == one.n_rows());
    std::map<std::string, double> size;
    for (const std::string &heading : one.headings)
      for (const double value : one[heading])
        size[group_of(heading)] = std::max(size[group_of(heading)], std::abs(value));

    for (const std::string &heading : one.headings)
      {
        if (ignores(heading))
          continue;
        double difference = 0.;
        for (std::size_t row = 0; row < one.n_rows(); ++row)
          difference = std::max(difference, std::abs(other[heading][row] - one[heading][row]));
        INFO(heading << " differs by " << difference);
        CHECK(difference <= tolerance * size[group_of(heading)]);
      }
  }
} // namespace magmpm::testing
