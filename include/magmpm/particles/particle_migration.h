#pragma once

#include <magmpm/particles/particle_set.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /**
   * Sends each particle to the rank that is to hold it, those of all sets in one exchange. Collective.
   *
   * @param destinations  rank of each particle, by set.
   * @return particles that this rank sent away.
   */
  template <int dim>
  std::size_t
  migrate_particles(const MPI_Comm communicator,
                    const std::vector<std::vector<unsigned int>> &destinations,
                    const std::vector<ParticleSet<dim> *> &sets);
} // namespace magmpm
