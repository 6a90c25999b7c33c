#pragma once

#include <string>

namespace magmpm
{
  /** A file or folder that a run leaves in its output folder, as the last lines of the log tell of it. */
  struct RunOutput
  {
    std::string name;
    std::string meaning;
  };
} // namespace magmpm
