#pragma once

#include <magmpm/elliptic/solve_report.h>

#include <cstddef>
#include <string>
#include <vector>

namespace magmpm
{
  /**
   * Force and torque of the material on the sources, known at a solve and carried between two: of each
   * source in turn the components of force [N] and torque [N m].
   */
  struct CarriedReactions
  {
    std::vector<double> now;
    std::vector<double> rate;  ///< per way of the fastest particle [.../m]
    unsigned int n_solves = 0; ///< so many had been done when they were found

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &now;
      archive &rate;
      archive &n_solves;
    }
  };

  /** Where a run is, and what its last step and solve did. */
  struct RunState
  {
    double time        = 0.; ///< [s]
    unsigned int step  = 0;
    unsigned int frame = 0;

    double time_step  = 0.; ///< of the last step [s]
    std::string limit = "none";

    /** The same of the last step that was not cut short to meet a frame. */
    double full_time_step  = 0.;
    std::string full_limit = "none";

    std::size_t lost_particles     = 0; ///< so far, all ranks
    std::size_t held_particles     = 0; ///< put back onto walls so far, all ranks
    std::size_t migrated_particles = 0; ///< so far, all ranks

    unsigned int mesh_changes = 0; ///< so far
    double imbalance     = 1.;     ///< load of the most loaded rank over the mean, at the last sort
    double density_error = 0.; ///< mean |J - J of the lattice| of fluids, at the last relaxation

    double max_speed = 0.; ///< of a particle in the last step [m/s]

    unsigned int n_solves           = 0; ///< of the potential, so far
    unsigned int step_of_last_solve = 0;
    bool solved_this_step           = false;
    SolveReport last_solve;

    /** The force at the last solve that fell on no mass and reaches no particle [N]. */
    double dropped_magnetic_force = 0.;

    /** What the next solve and the carried force depend on, since the last solve. */
    double time_of_last_solve = 0.; ///< [s]
    double drift_since_solve  = 0.; ///< the longest way of magnetic particles, or more [m]
    double path_since_solve   = 0.; ///< the sum of the steps of the fastest particles [m]
    double carried_way        = 0.; ///< for which the carried force was advanced [m]

    CarriedReactions reactions; ///< empty until somebody asks for them

    std::vector<double> rigid_bodies;          ///< RigidBodies::record()
    std::vector<double> rigid_bodies_at_solve; ///< the same at the last solve

    /** Of a particle into a rigid body since the last row of the statistics, on this rank [m]. */
    double deepest_penetration       = 0.;
    std::size_t particles_inside     = 0; ///< of rigid bodies, in the last step, all ranks
    std::size_t particles_pushed_out = 0; ///< of rigid bodies so far, all ranks

    double attraction = 0.; ///< g0 of the artificial attraction, matched to the magnets [m/s^2]

    /** Since when the material is at rest [s]; negative: it is not. */
    double rest_since = -1.;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time;
      archive &step;
      archive &frame;
      archive &time_step;
      archive &limit;
      archive &full_time_step;
      archive &full_limit;
      archive &lost_particles;
      archive &held_particles;
      archive &migrated_particles;
      archive &mesh_changes;
      archive &imbalance;
      archive &density_error;
      archive &max_speed;
      archive &n_solves;
      archive &step_of_last_solve;
      archive &solved_this_step;
      archive &last_solve;
      archive &dropped_magnetic_force;
      archive &time_of_last_solve;
      archive &drift_since_solve;
      archive &path_since_solve;
      archive &carried_way;
      archive &reactions;
      archive &rigid_bodies;
      archive &rigid_bodies_at_solve;
      archive &deepest_penetration;
      archive &particles_inside;
      archive &particles_pushed_out;
      archive &attraction;
      archive &rest_since;
    }
  };
} // namespace magmpm
