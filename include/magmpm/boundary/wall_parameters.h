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

  /** 90 degrees for each face. */
  template <int dim>
  constexpr std::array<double, 2 * dim>
  right_angles()
  {
    std::array<double, 2 *dim> angles = {};
    for (std::size_t face = 0; face < angles.size(); ++face)
      angles[face] = 90.;
    return angles;
  }

  /** Condition on the faces of the mechanical box: -x, +x, -y, +y, -z, +z. */
  template <int dim>
  struct WallParameters
  {
    std::array<WallCondition, 2 *dim> condition = {};
    std::array<double, 2 *dim> friction = {}; ///< Coulomb's coefficient, of slip and separate

    /** Of the surface of a fluid with tension, within the fluid; of slip and separate [degrees]. */
    std::array<double, 2 *dim> contact_angle = right_angles<dim>();

    /** Which faces are no walls. */
    std::array<bool, 2 * dim>
    open_faces() const
    {
      std::array<bool, 2 *dim> open = {};
      for (std::size_t face = 0; face < open.size(); ++face)
        open[face] = (condition[face] == WallCondition::open);
      return open;
    }

    /** Whether particles that leave the box are removed; otherwise they end the run. */
    bool removes_leaving_particles = false;
  };
} // namespace magmpm
