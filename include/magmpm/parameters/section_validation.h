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

  /** @return the shapes of the bodies, in their order. */
  template <int dim>
  std::vector<std::unique_ptr<Shape<dim>>>
  check_bodies(const ParameterRegister &declarations,
               const ParameterInput<dim> &input,
               Parameters<dim> &parameters);
} // namespace magmpm
