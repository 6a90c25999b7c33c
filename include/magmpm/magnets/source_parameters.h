#pragma once

#include <magmpm/base/tensor.h>

#include <string>

namespace magmpm
{
  enum class SourceType
  {
    uniform_field,
    magnetized_sphere ///< in 2D: a cylinder magnetized across its axis
  };

  /** What a solid magnet does to material at its surface. */
  enum class ContactCondition
  {
    none, ///< the source has no surface
    stick,
    slip,
    separate
  };

  /**
   * One named source of the external field. Vectors that change in time are given as expressions of
   * t [s] (one per component, constants included), evaluated by MotionScript.
   */
  template <int dim>
  struct SourceParameters
  {
    std::string name;
    SourceType type = SourceType::uniform_field;
    std::string field;             ///< uniform field H(t) [A/m], "0; 0; 1e5*t"
    std::string position;          ///< centre of the sphere x(t) [m], "0.5; 0.5; 0.2"
    std::string magnetization;     ///< M(t) [A/m]
    double radius            = 0.; ///< [m]
    ContactCondition contact = ContactCondition::none;
  };
} // namespace magmpm
