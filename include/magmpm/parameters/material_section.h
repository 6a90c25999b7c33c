#pragma once

#include <magmpm/materials/magnetization_curve.h>
#include <magmpm/materials/material_parameters.h>
#include <magmpm/parameters/parameter_register.h>

#include <optional>
#include <string>

/** The subsections of the section Materials. */
namespace magmpm
{
  /** The material of a parameter file, before either way of giving it becomes MaterialParameters. */
  struct MaterialInput
  {
    MechanicalLaw law = MechanicalLaw::neo_hookean;

    double youngs_modulus = 0., poisson_ratio = 0.; ///< either these
    double shear_modulus = 0., lame_lambda = 0.;    ///< or these
    double bulk_modulus = 0., viscosity = 0.;
    double sound_damping   = 0.1;
    double surface_tension = 0.;
    std::optional<Transfer> transfer; ///< none: that of the law

    double saturation_magnetization = 0., initial_susceptibility = 0.; ///< either these
    double grain_moment = 0., grain_number_density = 0.;               ///< or these
    double curve_factor = 0.;                                          ///< or this
  };

  void
  declare_material(ParameterRegister &declarations,
                   const std::string &name,
                   MaterialInput &material);

  /** What all materials of a scene share. */
  struct MaterialSetting
  {
    double lattice_spacing; ///< dx [m]
    MagnetizationLaw law;
    const MagnetizationCurve *curve; ///< null unless the law is table
    double temperature;              ///< [K]
  };

  /** @throw InputError  if something is missing, given in two ways, or makes no medium. */
  MaterialParameters
  convert_material(const ParameterRegister &declarations,
                   const std::string &name,
                   const MaterialInput &input,
                   const MaterialSetting &setting);
} // namespace magmpm
