#pragma once

#include <magmpm/parameters/magnet_section.h>
#include <magmpm/parameters/motion_input.h>
#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/parameters.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** The material of a parameter file, before either way of giving it becomes MaterialParameters. */
  struct MaterialInput
  {
    MechanicalLaw law = MechanicalLaw::neo_hookean;

    double youngs_modulus = 0., poisson_ratio = 0.; ///< either these
    double shear_modulus = 0., lame_lambda = 0.;    ///< or these
    double bulk_modulus = 0., viscosity = 0.;

    double saturation_magnetization = 0., initial_susceptibility = 0.; ///< either these
    double grain_moment = 0., grain_number_density = 0.;               ///< or these
    double curve_factor = 0.;                                          ///< or this
  };

  /** What the user gives, where it is not yet what Parameters holds. */
  template <int dim>
  struct ParameterInput
  {
    int dimension = dim;
    Vector<dim> lower_corner, upper_corner;
    double cell_size   = 0.;
    double temperature = 300.;
    std::string attraction_strength; ///< a number or match magnets
    std::string magnetization_curve; ///< a file
    std::string checkpoint_every = "10 min", end_wall_time = "never";
    std::vector<std::string> body_names, material_names, magnet_names, rigid_body_names;
    std::vector<MaterialInput> materials;        ///< in the order of material_names
    std::vector<MagnetInput<dim>> magnets;       ///< in the order of magnet_names
    std::vector<MotionInput> rigid_body_motions; ///< in the order of rigid_body_names
  };

  /**
   * Declares all parameters of a scene with the bodies, materials, magnets and rigid bodies named in @p input, and
   * binds them to @p input and @p parameters, whose lists get their length here.
   */
  template <int dim>
  void
  declare_parameters(ParameterRegister &declarations,
                     ParameterInput<dim> &input,
                     Parameters<dim> &parameters);
} // namespace magmpm
