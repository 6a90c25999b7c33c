#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/parameters/parameter_register.h>

#include <string>
#include <vector>

/** The section 'Shapes': shapes that bodies and rigid bodies are made of by union, difference and intersection. */
namespace magmpm
{
  /** Shapes and their names, in the order of 'List of shapes'. */
  template <int dim>
  struct NamedShapes
  {
    std::vector<std::string> names;
    std::vector<ShapeParameters<dim>> shapes;
  };

  /** Declares each shape in a subsection of its name. */
  template <int dim>
  void
  declare_shapes(ParameterRegister &declarations, NamedShapes<dim> &named);

  /**
   * Checks all shapes (check_shape()) and gives those made of others their parts.
   *
   * @throw InputError  if there is no shape of a name, or if a shape is made of itself.
   */
  template <int dim>
  void
  check_shapes(const ParameterRegister &declarations, NamedShapes<dim> &named);

  /**
   * Gives the shape in @p section its parts, if it is made of others, which must have theirs.
   *
   * @throw InputError  if there is no shape of a name, or only one name.
   */
  template <int dim>
  void
  take_parts(const ParameterRegister &declarations,
             const std::string &section,
             const NamedShapes<dim> &named,
             ShapeParameters<dim> &shape);
} // namespace magmpm
