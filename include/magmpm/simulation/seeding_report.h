#pragma once

#include <magmpm/particles/body.h>

#include <mpi.h>

#include <string>

namespace magmpm
{
  /**
   * Volume, mass, centroid and moments of inertia about it of a body as it was seeded, beside those of its
   * shape: a line each, in 2D per metre of depth. A list of points is its own shape. Collective.
   */
  template <int dim>
  std::string
  seeding_report(const BodyParameters<dim> &parameters,
                 const ParticleSet<dim> &particles,
                 const MPI_Comm communicator);
} // namespace magmpm
