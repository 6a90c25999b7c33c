#pragma once

#include <magmpm/parameters/parameter_declarations.h>

/** The larger sections of a parameter file, each declared in a file of its own. */
namespace magmpm
{
  /** Names of the faces of a box in the order of WallParameters. */
  inline const std::vector<std::string> face_names =
    {"Lower x", "Upper x", "Lower y", "Upper y", "Lower z", "Upper z"};

  /** One of the bodies: its shape, material and start. */
  template <int dim>
  void
  declare_body(ParameterRegister &declarations, BodyParameters<dim> &body);

  void
  declare_material(ParameterRegister &declarations,
                   const std::string &name,
                   MaterialInput &material);

  /** The section Attraction. */
  template <int dim>
  void
  declare_attraction(ParameterRegister &declarations,
                     ParameterInput<dim> &input,
                     PointAttraction<dim> &attraction);

  void
  declare_rest(ParameterRegister &declarations, RestParameters &rest);

  /** The section Magnetics: law, potential, solvers. */
  template <int dim>
  void
  declare_magnetics(ParameterRegister &declarations,
                    ParameterInput<dim> &input,
                    Parameters<dim> &parameters);
} // namespace magmpm
