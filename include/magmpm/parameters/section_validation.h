#pragma once

#include <magmpm/parameters/parameter_declarations.h>

#include <memory>

/** Parts of validate(), each in a file of its own; all throw InputError as it does. */
namespace magmpm
{
  /** The materials of @p input into those of @p parameters. */
  template <int dim>
  void
  convert_materials(const ParameterRegister &declarations,
                    const ParameterInput<dim> &input,
                    Parameters<dim> &parameters);

  /** Reads the file of the magnetization curve, where the law needs one. */
  template <int dim>
  void
  convert_magnetization_curve(const ParameterRegister &declarations,
                              const ParameterInput<dim> &input,
                              MagneticsParameters<dim> &magnetics);

  template <int dim>
  void
  convert_attraction(const ParameterRegister &declarations,
                     const ParameterInput<dim> &input,
                     Parameters<dim> &parameters);

  template <int dim>
  void
  check_rest(const ParameterRegister &declarations, const Parameters<dim> &parameters);

  /**
   * Checks that the shape in @p section is given, all of it and nothing else. The file of a mesh
   * becomes the path at which it is found.
   *
   * @return the shape.
   */
  template <int dim>
  std::unique_ptr<Shape<dim>>
  check_shape(const ParameterRegister &declarations,
              const std::string &section,
              ShapeParameters<dim> &parameters);

  /** Checks that the shape in @p section lies within the box of the lattice. */
  template <int dim>
  void
  check_inside_box(const ParameterRegister &declarations,
                   const std::string &section,
                   const ShapeType type,
                   const BoundingBox<dim> &reach,
                   const Lattice<dim> &lattice);

  /** @return the shapes of the bodies, in their order. */
  template <int dim>
  std::vector<std::unique_ptr<Shape<dim>>>
  check_bodies(const ParameterRegister &declarations,
               const ParameterInput<dim> &input,
               Parameters<dim> &parameters);

  /** The files of meshes and key frames become the paths at which they are found. */
  template <int dim>
  void
  check_sources(const ParameterRegister &declarations,
                Parameters<dim> &parameters,
                const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes);

  /** Also that a free magnet has mass, and a place to begin at; others must not have these. */
  template <int dim>
  void
  check_free_magnet(const ParameterRegister &declarations,
                    const std::string &section,
                    const SourceParameters<dim> &source);

  /** Reads how scripted bodies move. Adds to the warnings. */
  template <int dim>
  void
  check_rigid_bodies(const ParameterRegister &declarations,
                     const ParameterInput<dim> &input,
                     const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes,
                     Parameters<dim> &parameters);
} // namespace magmpm
