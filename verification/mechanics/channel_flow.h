#pragma once

namespace magmpm::verification
{
  enum class ChannelFlow
  {
    couette,   ///< u = U y/H: the upper wall moves
    poiseuille ///< u = g y (H - y)/(2 nu): a body force drives the fluid
  };

  /**
   * Profile of a viscous fluid between two walls to which it sticks, after the time H^2/nu, in the
   * middle of a layer six times as long as high, of which only the ends feel that it ends.
   *
   * @param cells  of the lattice over the height H.
   * @return the largest error of the mean velocity in a layer of one cell, over the largest velocity.
   */
  double
  velocity_error(const ChannelFlow flow, const int cells);
} // namespace magmpm::verification
