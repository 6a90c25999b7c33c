#include <magmpm/base/constants.h>
#include <magmpm/magnets/source_field.h>

namespace magmpm
{
  template <int dim>
  ForceAndTorque<dim>
  act_on(const std::vector<VolumeElement<dim>> &elements,
         const Vector<dim> &magnetization,
         const ActingField<dim> &acting)
  {
    ForceAndTorque<dim> sum;
    for (const VolumeElement<dim> &element : elements)
      {
        const LocalField<dim> local = acting(element.position);
        const double factor         = constants::vacuum_permeability * element.volume;
        // (M.grad)H has the components sum_j M_j dH_i/dx_j.
        const Vector<dim> force = factor * (local.gradient * magnetization);
        sum.force += force;
        sum.torque += cross(element.position, force) + factor * cross(magnetization, local.field);
      }
    return sum;
  }

  template ForceAndTorque<2>
  act_on(const std::vector<VolumeElement<2>> &, const Vector<2> &, const ActingField<2> &);
  template ForceAndTorque<3>
  act_on(const std::vector<VolumeElement<3>> &, const Vector<3> &, const ActingField<3> &);
} // namespace magmpm
