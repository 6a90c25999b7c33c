#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace magmpm::verification
{
  namespace
  {
    std::vector<std::string>
    cells_of(const std::string &line)
    {
      std::vector<std::string> cells;
      std::istringstream stream(line);
      for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(cell);
      return cells;
    }
  } // namespace

  Statistics::Statistics(const std::string &folder)
  {
    std::istringstream lines(contents(folder + "/statistics.csv"));
    std::string line;
    std::getline(lines, line);
    headings = cells_of(line);
    while (std::getline(lines, line))
      {
        const std::vector<std::string> row = cells_of(line);
        for (std::size_t c = 0; c < headings.size(); ++c)
          columns[headings[c]].push_back(std::strtod(row.at(c).c_str(), nullptr));
      }
    if (columns.empty())
      throw std::runtime_error("no statistics in " + folder);
  }

  std::vector<double>
  mechanical_energy(const Statistics &statistics)
  {
    std::vector<double> energy;
    for (std::size_t row = 0; row < statistics.n_rows(); ++row)
      energy.push_back(statistics["kinetic energy [J/m]"][row] +
                       statistics["elastic energy [J/m]"][row] +
                       statistics["gravitational energy [J/m]"][row]);
    return energy;
  }

  double
  late_mean(const std::vector<double> &column)
  {
    double sum              = 0.;
    const std::size_t first = column.size() * 3 / 4;
    for (std::size_t row = first; row < column.size(); ++row)
      sum += column[row];
    return sum / static_cast<double>(column.size() - first);
  }
} // namespace magmpm::verification
