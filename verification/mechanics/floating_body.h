#pragma once

#include <verification/mechanics/archimedes.h>

#include <string>

namespace magmpm::verification
{
  /** What floats: a rigid body along which the fluid slips, or an elastic block, which is material. */
  enum class FloaterKind
  {
    rigid,
    elastic
  };

  /** A pool 12 cells deep onto which a body 8 cells high is laid; in 2D 32 cells wide, in 3D 20 by 20. */
  struct FloatingBody
  {
    int dim          = 2;
    FloaterKind kind = FloaterKind::rigid;
    bool is_round    = true;
    double density   = 500.; ///< of the fluid it is 1000 [kg/m^3]
    int group        = 0;    ///< contact group of an elastic one; the fluid is in 0
  };

  /** Of the last quarter of the time; lengths in dx. */
  struct FloatingErrors
  {
    double height; ///< mean of its centre above floating_height(), as it is turned
    double swing;  ///< highest less lowest
    double turn;   ///< mean of a rigid body's, from upright [rad]: squares are not stable
  };

  FloatingErrors
  floating_errors(const FloatingBody &body);
} // namespace magmpm::verification
