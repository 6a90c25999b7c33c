#pragma once

#include <magmpm/boundary/rigid_body_parameters.h>
#include <magmpm/parameters/parameter_register.h>

#include <string>
#include <vector>

/** Mass and start of what forces move: parameters within the section of a magnet or a rigid body. */
namespace magmpm
{
  /** The names of the parameters. */
  inline const std::vector<std::string> parameters_of_free_body = {"Density",
                                                                   "Mass",
                                                                   "Velocity",
                                                                   "Angular velocity"};

  /** @param of_what  the beginning of each text: "Of a free body: ". */
  template <int dim>
  void
  declare_free_body(ParameterRegister &declarations,
                    RigidBodyProperties<dim> &properties,
                    const std::string &of_what);

  /**
   * Of a body that is free: that its density or its mass is given.
   *
   * @param reason      what says that it is free: "Free = true".
   * @throw InputError  if none of them is, or both.
   */
  void
  check_mass(const ParameterRegister &declarations,
             const std::string &section,
             const std::string &reason);
} // namespace magmpm
