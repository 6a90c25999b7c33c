#pragma once

#include <magmpm/coupling/clock.h>
#include <magmpm/parameters/run_parameters.h>
#include <magmpm/particles/body.h>
#include <magmpm/particles/particle_grid_transfer.h>

#include <mpi.h>

#include <vector>

namespace magmpm
{
  /** Speed of sound in the undeformed material of a body [m/s]. */
  template <int dim>
  double
  undeformed_wave_speed(const Body<dim> &body);

  /**
   * Notices a run that has gone astray in the step in which it happens. Collective.
   *
   * @param extremes  of each body after the step, over all ranks.
   * @param clock     where the scene is, for the message; its step is the one before.
   * @param limit     of the time step, likewise.
   * @throw RunError  on all ranks, naming the particle furthest beyond a limit, time and values.
   */
  template <int dim>
  void
  check_for_runaways(const std::vector<Body<dim>> &bodies,
                     const std::vector<ParticleExtremes> &extremes,
                     const RunawayLimits &limits,
                     const Clock &clock,
                     const std::string &limit,
                     const MPI_Comm communicator);
} // namespace magmpm
