#include <magmpm/parameters/parameter_sections.h>

namespace magmpm
{
  namespace
  {
    const NumberRange poisson_ratio_range = {-1., 0.5, true, true};

    void
    declare_moduli(ParameterRegister &declarations, MaterialInput &material)
    {
      declarations.add("Young's modulus",
                       material.youngs_modulus,
                       "Pa",
                       "Stiffness of a solid, together with the Poisson ratio.",
                       positive,
                       Presence::optional);
      declarations.add("Poisson ratio",
                       material.poisson_ratio,
                       "-",
                       "Transverse contraction of a solid, together with Young's modulus.",
                       poisson_ratio_range,
                       Presence::optional);
      declarations.add(
        "Shear modulus",
        material.shear_modulus,
        "Pa",
        "First Lame modulus mu of a solid, together with lambda, instead of E and nu.",
        positive,
        Presence::optional);
      declarations.add("Lame lambda",
                       material.lame_lambda,
                       "Pa",
                       "Second Lame modulus lambda of a solid, together with the shear modulus.",
                       any_number,
                       Presence::optional);
      declarations.add("Bulk modulus",
                       material.bulk_modulus,
                       "Pa",
                       "Resistance K of a fluid to compression.",
                       positive,
                       Presence::optional);
      declarations.add("Viscosity",
                       material.viscosity,
                       "Pa s",
                       "Shear viscosity mu_N of a fluid.",
                       not_negative,
                       Presence::optional);
    }

    void
    declare_magnetization(ParameterRegister &declarations, MaterialInput &material)
    {
      declarations.add("Saturation magnetization",
                       material.saturation_magnetization,
                       "A/m",
                       "M_s, together with the initial susceptibility; the linear law needs none.",
                       positive,
                       Presence::optional);
      declarations.add("Initial susceptibility",
                       material.initial_susceptibility,
                       "-",
                       "chi_0 = dM/dH without field; not given, nor grains: not magnetic.",
                       positive,
                       Presence::optional);
      declarations.add("Grain moment",
                       material.grain_moment,
                       "A m^2",
                       "Magnetic moment m of one grain, together with the grain number density, "
                       "instead of M_s = n m and chi_0 = mu_0 n m^2/(3 k_B T).",
                       positive,
                       Presence::optional);
      declarations.add(
        "Grain number density",
        material.grain_number_density,
        "1/m^3",
        "Grains n per volume of undeformed material, together with the grain moment.",
        positive,
        Presence::optional);
      declarations.add("Curve factor",
                       material.curve_factor,
                       "-",
                       "With Magnetization law = table: M of this material over that of the curve, "
                       "its concentration for instance; not given: not magnetic.",
                       positive,
                       Presence::optional);
    }
  } // namespace

  void
  declare_material(ParameterRegister &declarations,
                   const std::string &name,
                   MaterialInput &material)
  {
    const auto section = declarations.enter(name);
    declarations.add("Mechanical law",
                     material.law,
                     {{"neo-Hookean", MechanicalLaw::neo_hookean},
                      {"viscoelastic fluid", MechanicalLaw::viscoelastic_fluid}},
                     "What the material does when it is deformed.");
    declare_moduli(declarations, material);
    declare_magnetization(declarations, material);
  }

} // namespace magmpm
