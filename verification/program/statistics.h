#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace magmpm::verification
{
  /** The columns of a statistics.csv by heading. */
  class Statistics
  {
  public:
    /** @throw std::runtime_error if the folder has none. */
    explicit Statistics(const std::string &folder);

    const std::vector<double> &
    operator[](const std::string &heading) const
    {
      return columns.at(heading);
    }

    double
    last(const std::string &heading) const
    {
      return columns.at(heading).back();
    }

    std::size_t
    n_rows() const
    {
      return columns.at("step").size();
    }

    std::vector<std::string> headings;

  private:
    std::map<std::string, std::vector<double>> columns;
  };

  /** Kinetic, elastic and gravitational energy of each row, in 2D. */
  std::vector<double>
  mechanical_energy(const Statistics &statistics);

  /** The mean of a column over the last quarter of the rows. */
  double
  late_mean(const std::vector<double> &column);
} // namespace magmpm::verification
