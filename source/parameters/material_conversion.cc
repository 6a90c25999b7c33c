#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/section_validation.h>
#include <magmpm/materials/parameter_conversion.h>

#include <cmath>

namespace magmpm
{
  namespace
  {
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
      check_given(declarations, section, {}, {"Bulk modulus", "Viscosity"}, law);

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
                  MaterialParameters &material)
    {
      check_given(declarations,
                  section,
                  {"Bulk modulus", "Viscosity"},
                  {"Young's modulus", "Poisson ratio", "Shear modulus", "Lame lambda"},
                  "Mechanical law = viscoelastic fluid");
      material.bulk_modulus = input.bulk_modulus;
      material.viscosity    = input.viscosity;
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

  template <int dim>
  void
  convert_materials(const ParameterRegister &declarations,
                    const ParameterInput<dim> &input,
                    Parameters<dim> &parameters)
  {
    for (std::size_t i = 0; i < input.materials.size(); ++i)
      {
        MaterialParameters material;
        material.name             = input.material_names[i];
        material.law              = input.materials[i].law;
        const std::string section = "Materials/" + material.name;
        if (material.law == MechanicalLaw::neo_hookean)
          convert_solid(declarations, section, input.materials[i], material);
        else
          convert_fluid(declarations, section, input.materials[i], material);
        if (parameters.magnetics.law == MagnetizationLaw::table)
          material.magnetic = convert_curve(
            declarations, section, input.materials[i].curve_factor, *parameters.magnetics.curve);
        else
          material.magnetic = convert_magnetic(
            declarations, section, input.materials[i], parameters.magnetics.law, input.temperature);
        parameters.materials.push_back(material);
      }
  }

  template void
  convert_materials(const ParameterRegister &, const ParameterInput<2> &, Parameters<2> &);
  template void
  convert_materials(const ParameterRegister &, const ParameterInput<3> &, Parameters<3> &);
} // namespace magmpm
