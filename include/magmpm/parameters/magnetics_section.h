#pragma once

#include <magmpm/coupling/solve_trigger_parameters.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/magnetics/magnetics_parameters.h>
#include <magmpm/mesh/mesh_parameters.h>
#include <magmpm/parameters/parameter_register.h>

/** The section Magnetics: law, potential, solvers, and when to solve. */
namespace magmpm
{
  /** @param temperature  of the grains [K]. */
  template <int dim>
  void
  declare_magnetics(ParameterRegister &declarations,
                    double &temperature,
                    MagneticsParameters<dim> &magnetics,
                    MeshParameters<dim> &mesh,
                    SolveTriggerParameters &solve_trigger);

  /** Reads the file of the magnetization curve, where the law needs one. */
  template <int dim>
  void
  convert_magnetization_curve(const ParameterRegister &declarations,
                              MagneticsParameters<dim> &magnetics);

  /** Blocks have coordinates within +-2^20 (block_key()); some lie around the box. */
  template <int dim>
  void
  check_potential_box(const ParameterRegister &declarations,
                      const Lattice<dim> &lattice,
                      const MeshParameters<dim> &mesh);
} // namespace magmpm
