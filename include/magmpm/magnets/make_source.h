#pragma once

#include <magmpm/magnets/magnetic_source.h>
#include <magmpm/magnets/source_parameters.h>

#include <memory>

namespace magmpm
{
  /**
   * The source that the parameters describe, as it is at time zero.
   *
   * @throw InputError  names the source, what is wrong with it, and what is allowed.
   */
  template <int dim>
  std::unique_ptr<MagneticSource<dim>>
  make_source(const SourceParameters<dim> &parameters);
} // namespace magmpm
