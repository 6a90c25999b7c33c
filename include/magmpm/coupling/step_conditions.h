#pragma once

namespace magmpm
{
  /**
   * What limits the length of the next step, extremes over all particles and ranks. The scene says what
   * the motion of its particles and gravity contribute; then each coupling adds its part
   * (Coupling::limit_step()). TimeStepControl makes limits of it.
   */
  struct StepConditions
  {
    double signal_speed        = 0.; ///< wave speed of the deformed material + |v| [m/s]
    double magnetic_wave_speed = 0.; ///< sqrt(mu_0 |M|^2/rho) [m/s]
    double collider_speed      = 0.; ///< of rigid bodies [m/s]
    double kinematic_viscosity = 0.; ///< J mu_N/rho_0 [m^2/s]
    double acceleration = 0.; ///< the sum of the largest ones of all that acts on material [m/s^2]
    double affine_velocity    = 0.; ///< |C| [1/s]
    double rigid_acceleration = 0.; ///< of free rigid bodies, gravity at least [m/s^2]
    double capillary_rate     = 0.; ///< sqrt(gamma/(rho dx^3)) [1/s]
    double rotation_rate      = 0.; ///< of free rigid bodies: how fast they turn or swing [1/s]

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &signal_speed;
      archive &magnetic_wave_speed;
      archive &collider_speed;
      archive &kinematic_viscosity;
      archive &acceleration;
      archive &affine_velocity;
      archive &rigid_acceleration;
      archive &capillary_rate;
      archive &rotation_rate;
    }
  };
} // namespace magmpm
