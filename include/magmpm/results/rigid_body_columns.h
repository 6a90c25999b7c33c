#pragma once

#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/simulation/run_state.h>
#include <magmpm/results/statistics_file.h>

#include <vector>

namespace magmpm
{
  /**
   * The columns of statistics.csv about magnets and rigid bodies: force and torque of each magnet that
   * has a place, pose and motion of each rigid body that is not a scripted magnet, and, if there is any
   * rigid body with a surface, how deep particles are in these.
   */
  template <int dim>
  std::vector<StatisticsColumn>
  rigid_body_columns(const Parameters<dim> &parameters);

  /**
   * Sets them.
   *
   * @param forces  on each source.
   * @param state   with the deepest penetration of all ranks.
   */
  template <int dim>
  void
  set_rigid_body_columns(const Parameters<dim> &parameters,
                         const RigidBodies<dim> &bodies,
                         const std::vector<ForceAndTorque<dim>> &forces,
                         const RunState &state,
                         StatisticsFile &statistics);
} // namespace magmpm
