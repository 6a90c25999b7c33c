#pragma once

#include <magmpm/coupling/clock.h>
#include <magmpm/coupling/step_conditions.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/simulation/time_step_control.h>

#include <cstddef>
#include <string>
#include <vector>

namespace magmpm
{
  /** A line for the log. */
  struct Notice
  {
    bool is_warning = false;
    std::string text;
  };

  /** Where a scene is, apart from what its particles and couplings know; the same on all ranks. */
  template <int dim>
  struct SceneState
  {
    Clock clock;
    std::string limit = "none"; ///< of the last time step

    TimeStep last_full_step; ///< the last time step that was not cut short to meet a frame

    std::size_t lost_particles     = 0; ///< so far
    std::size_t migrated_particles = 0; ///< so far
    unsigned int mesh_changes      = 0; ///< so far
    double imbalance = 1.; ///< load of the most loaded rank over the mean, at the last sort
    double max_speed = 0.; ///< of a particle in the last step [m/s]

    StepConditions conditions; ///< of the next step

    /** Not part of a checkpoint. */
    std::vector<Notice> notices;
    std::vector<ParticleSums<dim>> sums; ///< of each body, when a step was asked for them last
    double fewest_particles = 0.;        ///< of a rank, then

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &clock;
      archive &limit;
      archive &last_full_step.length;
      archive &last_full_step.limit;
      archive &lost_particles;
      archive &migrated_particles;
      archive &mesh_changes;
      archive &imbalance;
      archive &max_speed;
      archive &conditions;
    }
  };
} // namespace magmpm
