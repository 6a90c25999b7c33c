#include <magmpm/materials/parameter_conversion.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/material_section.h>

#include <cmath>

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
      declarations.add(
        "Sound damping",
        material.sound_damping,
        "-",
        "Bulk viscosity of a fluid over rho c dx; not given: 0.1. It quiets the sound "
        "of a sudden start, which is slow here, and leaves what flows alone; much "
        "more limits the time step.",
        not_negative,
        Presence::optional);
      declarations.add("Surface tension",
                       material.surface_tension,
                       "N/m",
                       "gamma of the free surface of a fluid; not given: none. Water has 0.072, "
                       "ferrofluids of oil about 0.025.",
                       positive,
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

    /** At least so much must K dx be over gamma: sound is then as fast as 7 sqrt(gamma/(rho dx)). */
    constexpr double stiffness_over_tension = 50.;

    /** No medium of grains comes near; what does is a slip in a unit. */
    constexpr double max_susceptibility = 1e6;

    /** E and nu, or Lame's moduli: exactly one pair. */
    void
    convert_solid(const ParameterRegister &declarations,
                  const std::string &section,
                  const MaterialInput &input,
                  MaterialParameters &material)
    {
      const std::vector<std::string> engineers = {"Young's modulus", "Poisson ratio"};
      const std::vector<std::string> lames     = {"Shear modulus", "Lame lambda"};
      const std::string law                    = "Mechanical law = neo-Hookean";
      check_given(declarations,
                  section,
                  {},
                  {"Bulk modulus", "Viscosity", "Sound damping", "Surface tension"},
                  law);

      const bool by_engineers = !given_of(declarations, section, engineers).empty();
      const bool by_lame      = !given_of(declarations, section, lames).empty();
      if (by_engineers == by_lame)
        throw declarations.error(section + "/Mechanical law",
                                 std::string("the moduli are given ") +
                                   (by_lame ? "in two ways" : "in no way") +
                                   ". Give either Young's modulus and Poisson ratio, or Shear "
                                   "modulus and Lame lambda.");
      if (by_engineers)
        {
          check_given(declarations, section, engineers, {}, "the other one of this pair");
          const LameModuli moduli = lame_moduli(input.youngs_modulus, input.poisson_ratio);
          material.shear_modulus  = moduli.shear_modulus;
          material.lame_lambda    = moduli.lame_lambda;
          return;
        }
      check_given(declarations, section, lames, {}, "the other one of this pair");
      if (!(input.lame_lambda > -2. / 3. * input.shear_modulus))
        throw declarations.error(
          section + "/Lame lambda",
          "must be above -2/3 of the Shear modulus (" + to_text(-2. / 3. * input.shear_modulus) +
            " Pa): with less the material has no resistance to compression.");
      material.shear_modulus = input.shear_modulus;
      material.lame_lambda   = input.lame_lambda;
    }

    void
    convert_fluid(const ParameterRegister &declarations,
                  const std::string &section,
                  const MaterialInput &input,
                  const double lattice_spacing,
                  MaterialParameters &material)
    {
      check_given(declarations,
                  section,
                  {"Bulk modulus", "Viscosity"},
                  {"Young's modulus", "Poisson ratio", "Shear modulus", "Lame lambda"},
                  "Mechanical law = viscoelastic fluid");
      if (input.transfer == Transfer::fmpm)
        throw declarations.error(section + "/Transfer",
                                 "FMPM is for solids; a fluid has APIC. Leave it out.");
      material.bulk_modulus         = input.bulk_modulus;
      material.viscosity            = input.viscosity;
      material.sound_damping_length = input.sound_damping * lattice_spacing;
      material.surface_tension      = input.surface_tension;
      const double least_modulus = stiffness_over_tension * input.surface_tension / lattice_spacing;
      if (input.bulk_modulus < least_modulus)
        throw declarations.error(section + "/Surface tension",
                                 "sound is too slow for it: a surface of this tension would "
                                 "squeeze its outermost cells. Set "
                                 "the Bulk modulus to at least " +
                                   to_text(stiffness_over_tension) +
                                   " gamma/dx = " + to_text(least_modulus) +
                                   " Pa, better twice that, or take larger cells.");
    }

    /** That what a user gave makes a medium that can be computed; @p given is named if not. */
    MagneticParameters
    checked(const ParameterRegister &declarations,
            const std::string &given,
            const MagneticParameters &magnetic)
    {
      const double chi = magnetic.initial_susceptibility;
      if (!(chi > 0. && chi <= max_susceptibility))
        throw declarations.error(given,
                                 "it gives the material the initial susceptibility " +
                                   to_text(chi) + ", which must be above 0 and at most " +
                                   to_text(max_susceptibility) + ". Are the units right?");
      if (!std::isfinite(magnetic.saturation_magnetization) ||
          !std::isfinite(magnetic.number_density))
        throw declarations.error(given,
                                 "it gives the material the saturation magnetization " +
                                   to_text(magnetic.saturation_magnetization) + " A/m with " +
                                   to_text(magnetic.number_density) +
                                   " grains per m^3, which must be finite. Are the units right?");
      return magnetic;
    }

    /** With the law table: the curve times a factor, or not magnetic. */
    MagneticParameters
    convert_curve(const ParameterRegister &declarations,
                  const std::string &section,
                  const double factor,
                  const MagnetizationCurve &curve)
    {
      check_given(declarations,
                  section,
                  {},
                  {"Saturation magnetization",
                   "Initial susceptibility",
                   "Grain moment",
                   "Grain number density"},
                  "Magnetization law = table");
      if (!declarations.given(section + "/Curve factor"))
        return {};
      return checked(
        declarations,
        section + "/Curve factor",
        {factor * curve.saturation_magnetization(), factor * curve.initial_susceptibility(), 0.});
    }

    /** Saturation and susceptibility, or grains: at most one of these ways, and all of it. */
    MagneticParameters
    convert_magnetic(const ParameterRegister &declarations,
                     const std::string &section,
                     const MaterialInput &input,
                     const MagnetizationLaw law,
                     const double temperature)
    {
      const std::vector<std::string> saturation = {"Saturation magnetization",
                                                   "Initial susceptibility"};
      const std::vector<std::string> grains     = {"Grain moment", "Grain number density"};

      check_given(
        declarations, section, {}, {"Curve factor"}, "this Magnetization law (not table)");
      const std::vector<std::string> given = given_of(declarations, section, saturation);
      if (!given_of(declarations, section, grains).empty())
        {
          if (!given.empty())
            throw declarations.error(section + "/" + given.front(),
                                     "the magnetization is given in two ways. Give either " +
                                       saturation[0] + " and " + saturation[1] + ", or " +
                                       grains[0] + " and " + grains[1] + ".");
          check_given(declarations, section, grains, {}, "the other one of this pair");
          return checked(declarations,
                         section + "/" + grains[0],
                         magnetic_parameters_of_grains(
                           input.grain_moment, input.grain_number_density, temperature));
        }
      if (given.empty())
        return {};

      if (law == MagnetizationLaw::langevin)
        check_given(declarations, section, saturation, {}, "Magnetization law = Langevin");
      check_given(declarations, section, {saturation[1]}, {}, "a magnetic material");
      return checked(declarations,
                     section + "/" + saturation[1],
                     magnetic_parameters_of_saturation(
                       input.saturation_magnetization, input.initial_susceptibility, temperature));
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
    declarations.add(
      "Transfer",
      material.transfer,
      {{"auto", std::nullopt}, {"FMPM", Transfer::fmpm}, {"APIC", Transfer::apic}},
      "How velocities go from the lattice to the particles. FMPM, for solids alone, "
      "loses energy by time, whatever the number of steps, and keeps bent bodies right; "
      "APIC takes half of its time. auto: FMPM in solids, APIC in fluids.");
    declare_moduli(declarations, material);
    declare_magnetization(declarations, material);
  }

  MaterialParameters
  convert_material(const ParameterRegister &declarations,
                   const std::string &name,
                   const MaterialInput &input,
                   const MaterialSetting &setting)
  {
    MaterialParameters material;
    material.name             = name;
    material.law              = input.law;
    const std::string section = "Materials/" + name;
    if (material.law == MechanicalLaw::neo_hookean)
      {
        material.transfer = input.transfer.value_or(Transfer::fmpm);
        convert_solid(declarations, section, input, material);
      }
    else
      convert_fluid(declarations, section, input, setting.lattice_spacing, material);
    material.magnetic =
      setting.law == MagnetizationLaw::table
        ? convert_curve(declarations, section, input.curve_factor, *setting.curve)
        : convert_magnetic(declarations, section, input, setting.law, setting.temperature);
    return material;
  }
} // namespace magmpm
