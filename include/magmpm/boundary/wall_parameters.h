#pragma once

#include <array>

namespace magmpm
{
  enum class WallCondition
  {
    stick,
    slip,
    separate
  };

  /** Condition on the faces of the mechanical box: -x, +x, -y, +y, -z, +z. */
  template <int dim>
  struct WallParameters
  {
    std::array<WallCondition, 2 *dim> condition = {};
  };
} // namespace magmpm
