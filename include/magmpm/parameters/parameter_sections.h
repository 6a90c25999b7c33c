#pragma once

#include <magmpm/parameters/parameter_declarations.h>

/** The larger sections of a parameter file, each declared in a file of its own. */
namespace magmpm
{
  inline const NumberRange at_least_one = {1., any_number.maximum, false, false};

  /** Names of the faces of a box in the order of WallParameters. */
  inline const std::vector<std::string> face_names =
    {"Lower x", "Upper x", "Lower y", "Upper y", "Lower z", "Upper z"};

  /** One of the bodies: its shape, material and start. */
  template <int dim>
  void
  declare_body(ParameterRegister &declarations, BodyParameters<dim> &body);

  /**
   * The shape of a body or something else in the section entered, see check_shape().
   *
   * @param may_be_points  whether a list of points will do.
   */
  template <int dim>
  void
  declare_shape(ParameterRegister &declarations,
                ShapeParameters<dim> &shape,
                const bool may_be_points = false);

  void
  declare_material(ParameterRegister &declarations,
                   const std::string &name,
                   MaterialInput &material);

  /** One of the magnets. */
  template <int dim>
  void
  declare_source(ParameterRegister &declarations, SourceParameters<dim> &source);

  /** What a free magnet needs, within the section of the magnet. */
  template <int dim>
  void
  declare_free_magnet(ParameterRegister &declarations, SourceParameters<dim> &source);

  /** One of the rigid bodies: its shape, mass, motion and surface. */
  template <int dim>
  void
  declare_rigid_body(ParameterRegister &declarations,
                     RigidBodyParameters<dim> &body,
                     MotionInput &motion);

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
