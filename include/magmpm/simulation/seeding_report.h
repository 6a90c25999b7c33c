#pragma once

#include <magmpm/particles/body.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * A table of volume, mass, centroid and moments of inertia about it (about the axes; in 2D, where all is per
   * metre of depth, the one across the plane) of bodies as they were seeded, below each that of its shape; a
   * list of points has none. Of a hydrostatic body it is the shape full of undeformed fluid, which weighs less.
   * Collective; the same on all ranks.
   */
  template <int dim>
  std::string
  seeding_report(const std::vector<BodyParameters<dim>> &parameters,
                 const std::vector<Body<dim>> &bodies,
                 const MPI_Comm communicator);
} // namespace magmpm
