#pragma once

#include <string>
#include <vector>

namespace magmpm
{
  /** Names of the faces of a box in the order of WallParameters. */
  inline const std::vector<std::string> face_names =
    {"Lower x", "Upper x", "Lower y", "Upper y", "Lower z", "Upper z"};
} // namespace magmpm
