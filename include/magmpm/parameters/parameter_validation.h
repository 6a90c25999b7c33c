#pragma once

#include <magmpm/parameters/parameter_declarations.h>

namespace magmpm
{
  /**
   * Checks the relations between parameters and converts what was given into what @p parameters
   * holds (lattice, moduli, magnetic content). The ranges of single values were checked by
   * ParameterRegister::apply() before.
   *
   * @param declarations  what the user gave, for messages that name it.
   * @param input         what the user gave, as it comes.
   * @param parameters    filled by apply(); complete and warned about afterwards.
   * @throw InputError    at the first relation that does not hold.
   */
  template <int dim>
  void
  validate(const ParameterRegister &declarations,
           const ParameterInput<dim> &input,
           Parameters<dim> &parameters);
} // namespace magmpm
