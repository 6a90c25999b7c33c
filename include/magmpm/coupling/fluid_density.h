#pragma once

#include <magmpm/mesh/block_partition.h>
#include <magmpm/coupling/density_relaxation.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /**
   * Draws the J of fluids towards that of the lattice, see density_relaxation.h. Collective.
   *
   * @param time     since the last time [s].
   * @param scratch  a field on the blocks of @p partition; its values are lost.
   * @return mean |J - J of the lattice| before, of particles that are not next to a free surface.
   */
  template <int dim>
  double
  relax_density(const double time,
                const BlockPartition<dim> &partition,
                const Lattice<dim> &lattice,
                const OpenFaces<dim> &open,
                const MPI_Comm communicator,
                NodeField<dim> &scratch,
                std::vector<Body<dim>> &bodies);
} // namespace magmpm
