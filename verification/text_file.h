#pragma once

#include <fstream>
#include <sstream>
#include <string>

namespace magmpm::verification
{
  /** All that a file holds; "" if there is none. */
  inline std::string
  contents(const std::string &path)
  {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
} // namespace magmpm::verification
