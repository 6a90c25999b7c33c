#pragma once

#include <array>

namespace magmpm
{
  enum class WallCondition
  {
    stick,
    slip,
    separate,
    open ///< no wall: particles leave there
  };

  /** Condition on the faces of the mechanical box: -x, +x, -y, +y, -z, +z. */
  template <int dim>
  struct WallParameters
  {
    std::array<WallCondition, 2 *dim> condition = {};

    /** Whether particles that leave the box are removed; otherwise they end the run. */
    bool removes_leaving_particles = false;
  };
} // namespace magmpm
