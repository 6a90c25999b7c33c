#pragma once

#include <magmpm/magnets/source_field.h>

namespace magmpm
{
  /** A piece of a line that carries a current. */
  struct CurrentElement
  {
    Vector<3> position; ///< [m]
    Vector<3> line;     ///< its length, in the direction of the current [m]
  };

  /** Force and torque on pieces of a line that carry @p current [A]: F = sum I dl x B, B = mu_0 H. */
  ForceAndTorque<3>
  act_on(const std::vector<CurrentElement> &elements,
         const double current,
         const ActingField<3> &acting);
} // namespace magmpm
