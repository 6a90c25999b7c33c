#pragma once

#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_grid_transfer.h>
#include <magmpm/particles/particle_sums.h>

#include <mpi.h>

#include <vector>

/** What the particles of all ranks come to, body by body. All functions are collective. */
namespace magmpm
{
  template <int dim>
  std::vector<ParticleSums<dim>>
  sums_over_ranks(const std::vector<Body<dim>> &bodies,
                  const Parameters<dim> &parameters,
                  const MPI_Comm communicator);

  /**
   * Replaces the extremes of this rank by those of all ranks.
   *
   * @param number  of this rank.
   * @return the largest number of all ranks, found in the same exchange.
   */
  double
  maximize_over_ranks(std::vector<ParticleExtremes> &extremes,
                      const double number,
                      const MPI_Comm communicator);
} // namespace magmpm
