#pragma once

#include <magmpm/io/parameter_declarations.h>

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

  template <int dim>
  void
  check_bodies(const ParameterRegister &declarations,
               const ParameterInput<dim> &input,
               const Parameters<dim> &parameters);

  template <int dim>
  void
  check_sources(const ParameterRegister &declarations, const Parameters<dim> &parameters);
} // namespace magmpm
