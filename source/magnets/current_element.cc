#include <magmpm/base/constants.h>
#include <magmpm/magnets/current_element.h>

namespace magmpm
{
  ForceAndTorque<3>
  act_on(const std::vector<CurrentElement> &elements,
         const double current,
         const ActingField<3> &acting)
  {
    ForceAndTorque<3> sum;
    for (const CurrentElement &element : elements)
      {
        const Vector<3> field = acting(element.position).field;
        const Vector<3> force = (constants::vacuum_permeability * current) *
                                cross(element.line, field);
        sum.force += force;
        sum.torque += cross(element.position, force);
      }
    return sum;
  }
} // namespace magmpm
