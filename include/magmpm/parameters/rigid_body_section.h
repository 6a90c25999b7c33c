#pragma once

#include <magmpm/boundary/rigid_body_parameters.h>
#include <magmpm/parameters/motion_input.h>
#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/parameters/shapes_section.h>

#include <memory>
#include <vector>

/** The subsections of the section Rigid bodies. */
namespace magmpm
{
  /** One of the rigid bodies: its shape, mass, motion and surface. */
  template <int dim>
  void
  declare_rigid_body(ParameterRegister &declarations,
                     RigidBodyParameters<dim> &body,
                     MotionInput &motion);

  /**
   * Checks all rigid bodies, and reads how scripted ones move.
   *
   * @param motions     in their order.
   * @param named_shapes  the shapes that they may be made of.
   * @param parameters  their rigid_bodies, and warnings are added.
   * @throw InputError  says which line is wrong.
   */
  template <int dim>
  void
  check_rigid_bodies(const ParameterRegister &declarations,
                     const std::vector<MotionInput> &motions,
                     const NamedShapes<dim> &named_shapes,
                     const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes,
                     Parameters<dim> &parameters);
} // namespace magmpm
