#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** A figure and the largest value that it may have. */
  struct LimitRow
  {
    std::string name;
    double value;
    double limit = std::numeric_limits<double>::infinity(); ///< none: shown beside others
  };

  /** A run that gives one row or several. */
  struct LimitCase
  {
    std::string name;
    std::function<std::vector<LimitRow>()> rows;
  };

  /**
   * Carries out the cases whose names begin with a text, and prints their rows as they come: as a table that
   * marks values beyond their limit as missed, or as name,value,limit.
   */
  void
  print_limit_rows(const std::vector<LimitCase> &cases,
                   const std::string &beginning,
                   const bool as_csv);
} // namespace magmpm::benchmarks
