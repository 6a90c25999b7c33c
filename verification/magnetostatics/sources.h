#pragma once

#include <magmpm/magnets/source_parameters.h>

namespace magmpm::verification
{
  /** A uniform field H_0 [A/m]. */
  template <int dim>
  SourceParameters<dim>
  uniform_source(const Vector<dim> &field);

  /** A magnetized sphere, outside of which the field is that of a dipole in its centre. */
  template <int dim>
  SourceParameters<dim>
  magnet_source(const Vector<dim> &centre, const double radius, const Vector<dim> &magnetization);
} // namespace magmpm::verification
