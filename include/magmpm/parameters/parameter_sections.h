#pragma once

#include <magmpm/parameters/box_section.h>
#include <magmpm/parameters/contact_section.h>
#include <magmpm/parameters/magnet_section.h>
#include <magmpm/parameters/material_section.h>
#include <magmpm/parameters/motion_input.h>
#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/parameters/shapes_section.h>

#include <string>
#include <vector>

/** All sections of a parameter file, each of which is declared and checked in a file of its own. */
namespace magmpm
{
  /** What the user gives, where it is not yet what Parameters holds. */
  template <int dim>
  struct ParameterInput
  {
    int dimension = dim;
    std::string gravity;       ///< expressions of t [m/s^2]
    double temperature = 300.; ///< of the grains [K]
    BoxInput<dim> box;
    NamedShapes<dim> shapes;
    std::vector<std::string> body_names, material_names, magnet_names, rigid_body_names,
      contact_names;
    std::vector<MaterialInput> materials;        ///< in the order of material_names
    std::vector<MagnetInput<dim>> magnets;       ///< in the order of magnet_names
    std::vector<MotionInput> rigid_body_motions; ///< in the order of rigid_body_names
    std::vector<ContactInput> contacts;          ///< in the order of contact_names
  };

  /**
   * Declares all parameters of a scene with the shapes, bodies, materials, magnets, rigid bodies and contacts named in @p input, and
   * binds them to @p input and @p parameters, whose lists get their length here.
   */
  template <int dim>
  void
  declare_parameters(ParameterRegister &declarations,
                     ParameterInput<dim> &input,
                     Parameters<dim> &parameters);

  /**
   * Checks the relations between parameters and converts what was given into what @p parameters
   * holds (lattice, moduli, magnetic content). The ranges of single values were checked by
   * ParameterRegister::apply() before.
   *
   * @param declarations  what the user gave, for messages that name it.
   * @param input         what the user gave, as it comes; its shapes get their parts.
   * @param parameters    filled by apply(); complete and warned about afterwards.
   * @throw InputError    at the first relation that does not hold.
   */
  template <int dim>
  void
  validate(const ParameterRegister &declarations,
           ParameterInput<dim> &input,
           Parameters<dim> &parameters);
} // namespace magmpm
