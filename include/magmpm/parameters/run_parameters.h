#pragma once

#include <limits>
#include <string>
#include <vector>

namespace magmpm
{
  /** The length of a time step: the smallest of the limits below, or a fixed one. */
  struct TimeStepParameters
  {
    double fixed_step       = 0.;    ///< dt [s]; 0: as long as the limits allow
    bool allow_unstable     = false; ///< a fixed step beyond the limits
    double maximum          = std::numeric_limits<double>::infinity(); ///< [s], of a step not fixed
    double elastic_factor   = 0.4;  ///< dt <= factor dx / (c + |v|)
    double viscous_factor   = 0.12; ///< dt <= factor rho dx^2 / mu_N
    double force_factor     = 0.3;  ///< dt <= factor sqrt(dx / |a|)
    double affine_factor    = 0.3;  ///< dt <= factor / |C|
    double capillary_factor = 0.1;  ///< dt <= factor sqrt(rho dx^3/gamma)
  };

  /** How a scene comes to rest, and whether the run ends then. */
  struct RestParameters
  {
    double damping_rate = 0.;    ///< dv/dt = -rate v [1/s]
    bool stops          = false; ///< the run ends when all material is at rest:
    double speed        = 0.;    ///< the root mean square of the speed is below this [m/s] ..
    double duration     = 0.;    ///< .. for so long [s]
  };

  /** Beyond these a run has failed: it stops, keeps the last good output and names the particle. */
  struct RunawayLimits
  {
    double min_volume_ratio = 0.05; ///< J
    double max_volume_ratio = 20.;  ///< J
    double max_speed_ratio  = 20.;  ///< speed over the undeformed wave speed of the material
  };

  /** When a run writes checkpoints, and when it stops by itself before its end time. */
  struct CheckpointParameters
  {
    int every_n_frames   = 0;                                       ///< 0: not by frames
    double wall_interval = std::numeric_limits<double>::infinity(); ///< between two checkpoints [s]
    double end_wall_time = std::numeric_limits<double>::infinity(); ///< since the program began [s]
    int n_kept           = 2;

    /** Whether the run writes any by itself. */
    bool
    is_wanted() const
    {
      return every_n_frames > 0 || wall_interval < std::numeric_limits<double>::infinity();
    }
  };

  /** What is written, where and how often. */
  struct OutputParameters
  {
    std::string directory;
    double frame_interval   = 0.; ///< simulated time between frames [s]
    bool write_particles    = true;
    bool write_fields       = true;
    bool write_rigid_bodies = true;
    bool write_surface      = false;
    std::vector<std::string> particle_quantities; ///< names in particle_quantities()
    std::vector<std::string> field_quantities;    ///< names in field_quantities()
    int statistics_every = 1;                     ///< steps
  };
} // namespace magmpm
