#include <magmpm/parameters/free_body_section.h>
#include <magmpm/parameters/given_parameters.h>

namespace magmpm
{
  template <int dim>
  void
  declare_free_body(ParameterRegister &declarations,
                    RigidBodyProperties<dim> &properties,
                    const std::string &of_what)
  {
    declarations.add("Density",
                     properties.density,
                     "kg/m^3",
                     of_what + "its density, if its mass is not given.",
                     positive,
                     Presence::optional);
    declarations.add("Mass",
                     properties.mass,
                     dim == 3 ? "kg" : "kg/m",
                     of_what + "its mass, in 2D per metre of depth, if its density is not given; "
                               "spread evenly over its shape.",
                     positive,
                     Presence::optional);
    declarations.add("Velocity",
                     properties.velocity,
                     "m/s",
                     of_what + "velocity of its centre of mass at the start. Not given: 0.",
                     Presence::optional);
    declarations.add("Angular velocity",
                     properties.angular_velocity,
                     "rad/s",
                     of_what + "spin at the start about the centre of mass. Not given: 0.",
                     Presence::optional);
  }

  void
  check_mass(const ParameterRegister &declarations,
             const std::string &section,
             const std::string &reason)
  {
    const auto given = given_of(declarations, section, {"Density", "Mass"});
    if (given.size() != 1)
      throw InputError(declarations.where(section + "/Density") + ": with " + reason +
                       " exactly one of Density and Mass must be given, but " +
                       (given.empty() ? "none" : "both") + (given.empty() ? " is." : " are."));
  }

  template void
  declare_free_body(ParameterRegister &, RigidBodyProperties<2> &, const std::string &);
  template void
  declare_free_body(ParameterRegister &, RigidBodyProperties<3> &, const std::string &);
} // namespace magmpm
