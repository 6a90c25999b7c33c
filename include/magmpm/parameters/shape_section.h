#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/parameters/parameter_register.h>
#include <magmpm/parameters/shapes_section.h>

#include <memory>
#include <string>

/** The shape of a body or a rigid body: parameters within its section. */
namespace magmpm
{
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

  /**
   * Checks that the shape in @p section is given, all of it and nothing else. The file of a mesh
   * becomes the path at which it is found, names of shapes that it is made of become these shapes.
   *
   * @param named  the shapes that it may be made of, checked before.
   * @return the shape.
   * @throw InputError  otherwise.
   */
  template <int dim>
  std::unique_ptr<Shape<dim>>
  check_shape(const ParameterRegister &declarations,
              const std::string &section,
              const NamedShapes<dim> &named,
              ShapeParameters<dim> &parameters);

  /** Checks that the shape in @p section lies within the box of the lattice. @throw InputError  if not. */
  template <int dim>
  void
  check_inside_box(const ParameterRegister &declarations,
                   const std::string &section,
                   const ShapeType type,
                   const BoundingBox<dim> &reach,
                   const Lattice<dim> &lattice);
} // namespace magmpm
