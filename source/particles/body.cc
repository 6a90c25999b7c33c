#include <magmpm/particles/body.h>

namespace magmpm
{
  template <int dim>
  Material<dim>
  make_material(const MaterialParameters &parameters, const double density)
  {
    switch (parameters.law)
      {
        case MechanicalLaw::viscoelastic_fluid:
          return make_viscoelastic_fluid<dim>(parameters, density);
        case MechanicalLaw::neo_hookean:
        default:
          return make_neo_hookean<dim>(parameters, density);
      }
  }

  template <int dim>
  Body<dim>::Body(const BodyParameters<dim> &parameters, const MaterialParameters &material)
    : name(parameters.name)
    , material(make_material<dim>(material, parameters.density))
    , magnetic(material.magnetic)
    , particles(material.law == MechanicalLaw::neo_hookean, material.magnetic.is_magnetic())
  {
  }

  template Material<2>
  make_material<2>(const MaterialParameters &, double);
  template Material<3>
  make_material<3>(const MaterialParameters &, double);
  template struct Body<2>;
  template struct Body<3>;
} // namespace magmpm
