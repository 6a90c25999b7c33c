#pragma once

#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/body.h>

#include <mpi.h>

#include <string>
#include <vector>

namespace magmpm
{
  /**
   * The acceleration g0 with which the attraction has the total force, in size, that the bodies carry
   * from the magnets [m/s^2]. Collective.
   *
   * @throw RunError  if one of the two forces is zero.
   */
  template <int dim>
  double
  matched_acceleration(const Parameters<dim> &parameters,
                       const std::vector<Body<dim>> &bodies,
                       const MPI_Comm communicator);

  /** A line on it for the log. */
  template <int dim>
  std::string
  description(const PointAttraction<dim> &attraction);
} // namespace magmpm
