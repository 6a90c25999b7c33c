#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/parameters/shapes_section.h>
#include <magmpm/particles/body_parameters.h>

#include <memory>
#include <string>
#include <vector>

/** The subsections of the section Bodies. */
namespace magmpm
{
  /** One of the bodies: its shape, material and start. */
  template <int dim>
  void
  declare_body(ParameterRegister &declarations, BodyParameters<dim> &body);

  /**
   * Checks that bodies lie within the box and apart, and that their materials are among those listed.
   *
   * @return the shapes of the bodies, in their order.
   */
  template <int dim>
  std::vector<std::unique_ptr<Shape<dim>>>
  check_bodies(const ParameterRegister &declarations,
               const std::vector<std::string> &material_names,
               const NamedShapes<dim> &named_shapes,
               const Lattice<dim> &lattice,
               std::vector<BodyParameters<dim>> &bodies);

  /** Checks that hydrostatic bodies are fluids with a shape, in gravity. */
  template <int dim>
  void
  check_initial_states(const ParameterRegister &declarations, const Parameters<dim> &parameters);
} // namespace magmpm
