#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/parameters/parameter_register.h>

/** The section Box: the walls and the lattice within. */
namespace magmpm
{
  /** What the user gives of the box. */
  template <int dim>
  struct BoxInput
  {
    Vector<dim> lower_corner, upper_corner; ///< [m]
    double cell_size = 0.;                  ///< [m]
  };

  template <int dim>
  void
  declare_box(ParameterRegister &declarations, BoxInput<dim> &box);

  /** The lattice in the box. @throw InputError if its cells do not fill it. */
  template <int dim>
  Lattice<dim>
  lattice_of_box(const ParameterRegister &declarations, const BoxInput<dim> &box);
} // namespace magmpm
