#pragma once

#include <magmpm/particles/particle_set.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /**
   * Sends each particle to the rank that is to hold it. Collective.
   *
   * @param destination  rank of each particle.
   * @return particles that this rank sent away.
   */
  template <int dim>
  std::size_t
  migrate_particles(const MPI_Comm communicator,
                    const std::vector<unsigned int> &destination,
                    ParticleSet<dim> &particles);
} // namespace magmpm
