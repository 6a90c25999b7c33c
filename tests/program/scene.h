#pragma once

#include "program/program.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/** Small scenes that tests run, and what the runs wrote of themselves. */
namespace magmpm::testing
{
  /** The columns of a statistics.csv by heading. */
  class Statistics
  {
  public:
    explicit Statistics(const std::string &folder)
    {
      std::istringstream lines(contents(folder + "/statistics.csv"));
      std::string line;
      std::getline(lines, line);
      for (const std::string &heading : cells(line))
        headings.push_back(heading);
      while (std::getline(lines, line))
        {
          const std::vector<std::string> row = cells(line);
          for (std::size_t c = 0; c < headings.size(); ++c)
            columns[headings[c]].push_back(std::strtod(row.at(c).c_str(), nullptr));
        }
      if (columns.empty())
        throw std::runtime_error("no statistics in " + folder);
    }

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
    static std::vector<std::string>
    cells(const std::string &line)
    {
      std::vector<std::string> cells;
      std::istringstream stream(line);
      for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(cell);
      return cells;
    }

    std::map<std::string, std::vector<double>> columns;
  };

  /** Writes a parameter file NAME.prm whose results go to output-NAME. */
  inline std::string
  write_scene(const std::string &name, const std::string &text)
  {
    std::ofstream(name + ".prm") << text << "set Output directory = output-" << name << '\n';
    return name + ".prm";
  }
} // namespace magmpm::testing
