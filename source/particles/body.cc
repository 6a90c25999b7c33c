#include <magmpm/particles/body.h>
#include <magmpm/particles/make_material.h>

namespace magmpm
{
  template <int dim>
  Body<dim>::Body(const BodyParameters<dim> &parameters, const MaterialParameters &material)
    : name(parameters.name)
    , material(make_material<dim>(material, parameters.density))
    , magnetic(material.magnetic)
    , transfer(material.transfer)
    , surface_tension(material.surface_tension)
    , contact_group(parameters.contact_group)
    , particles(material.law == MechanicalLaw::neo_hookean,
                material.magnetic.is_magnetic(),
                smoothed_modulus(this->material) > 0.)
  {
  }

  template struct Body<2>;
  template struct Body<3>;
} // namespace magmpm
