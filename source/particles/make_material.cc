#include <magmpm/particles/make_material.h>

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

  template Material<2>
  make_material(const MaterialParameters &, double);
  template Material<3>
  make_material(const MaterialParameters &, double);
} // namespace magmpm
