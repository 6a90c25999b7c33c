#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /** How full of a body the lattice is, on the nodes of a box around it. */
  template <int dim>
  struct VolumeFraction
  {
    Index<dim> first = {};      ///< node in the lower corner of the box
    Index<dim> count = {};      ///< nodes along each axis; all 0 without particles
    std::vector<double> values; ///< sum of N J V_0 over dx^dim [-], the first axis running fastest
  };

  /**
   * Scatters the volumes J V_0 of the particles of all ranks with the quadratic B-splines of P2G. The
   * outermost nodes of the box are empty. Collective; the values arrive on rank 0 alone.
   */
  template <int dim>
  VolumeFraction<dim>
  volume_fraction(const Body<dim> &body, const Lattice<dim> &lattice, const MPI_Comm communicator);
} // namespace magmpm
