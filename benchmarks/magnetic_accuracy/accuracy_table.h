#pragma once

#include <verification/magnetostatics/accuracy_case.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace magmpm::benchmarks
{
  /** What all errors of a case belong to. */
  struct CaseName
  {
    int dim;
    std::string group;
    std::string variant; ///< of the group, or ""
    double resolution;   ///< R/dx
  };

  /** Prints errors beside their limits as they come, and counts the missed limits. */
  class AccuracyTable
  {
  public:
    AccuracyTable(std::ostream &stream, const bool csv);

    /** A row for each error of a case: rms and largest over the offsets. */
    void
    add(const CaseName &name, const std::vector<verification::Errors> &offsets);

    /** Order of convergence of each error of the series, if it has two resolutions. */
    void
    add_orders();

    /** What follows is of another group or variant. */
    void
    end_series();

    int
    n_missed() const
    {
      return missed;
    }

  private:
    std::ostream &stream;
    const bool csv;
    int missed = 0;

    /** Of the present series. */
    struct Point
    {
      double resolution;
      verification::Errors rms;
    };
    CaseName last_name;
    std::vector<Point> points;

    void
    print_row(const CaseName &name,
              const std::size_t n_offsets,
              const std::string &measure,
              const double rms,
              const double largest);
  };
} // namespace magmpm::benchmarks
