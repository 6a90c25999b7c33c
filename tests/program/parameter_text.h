#pragma once

#include <verification/program/parameter_text.h>
#include <verification/program/statistics.h>
#include <verification/text_file.h>

#include <sstream>
#include <string>

namespace magmpm::testing
{
  using verification::mechanical_energy;
  using verification::ParameterText;

  /** Rows of a column of text: here the limits of dt. */
  inline int
  rows_with(const std::string &folder, const std::string &word)
  {
    std::istringstream lines(verification::contents(folder + "/statistics.csv"));
    int n = 0;
    for (std::string line; std::getline(lines, line);)
      n += (line.find("," + word + ",") != std::string::npos);
    return n;
  }
} // namespace magmpm::testing
