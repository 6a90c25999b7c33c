#pragma once

#include <magmpm/parameters/run_parameters.h>

#include <string>

namespace magmpm
{
  /** The limit of a step that was cut short to meet a frame. */
  inline constexpr const char *frame_end_limit = "frame end";

  /** A time step and the limit that bound it. */
  struct TimeStep
  {
    double length = 0.; ///< dt [s]
    std::string limit;  ///< elastic, viscous, force, affine, rotation, maximum, frame end or fixed
  };

  /** The state of the material that limits the next step, extremes over all particles and ranks. */
  struct StepConditions
  {
    double signal_speed        = 0.; ///< wave speed of the deformed material + |v| [m/s]
    double magnetic_wave_speed = 0.; ///< sqrt(mu_0 |M|^2/rho) [m/s]
    double collider_speed      = 0.; ///< [m/s]
    double kinematic_viscosity = 0.; ///< J mu_N/rho_0 [m^2/s]
    double acceleration        = 0.; ///< of gravity and magnets [m/s^2]
    double affine_velocity     = 0.; ///< |C| [1/s]
    double rigid_acceleration  = 0.; ///< of free rigid bodies [m/s^2]
    double rotation_rate       = 0.; ///< of free rigid bodies: how fast they turn or swing [1/s]
    double attraction          = 0.; ///< of the artificial attraction [m/s^2]

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
      archive &rotation_rate;
      archive &attraction;
    }
  };

  /**
   * Chooses the length of each time step: symplectic Euler is stable and particles stay close to
   * their blocks if no signal crosses more than a fraction of a cell.
   *
   *   elastic:  dt <= elastic factor dx/(c + |v|), c with the magnetic waves
   *   viscous:  dt <= viscous factor dx^2/(J mu_N/rho_0)
   *   force:    dt <= force factor sqrt(dx/|a|)
   *   affine:   dt <= affine factor/|C|
   *   rotation: dt <= affine factor/omega, of free rigid bodies
   *
   * A fixed step is checked against these limits, unless the user allows an unstable one. The step
   * before a frame is shortened to meet it ("frame end").
   */
  class TimeStepControl
  {
  public:
    TimeStepControl(const TimeStepParameters &parameters, const double lattice_spacing);

    /**
     * @param time        of the start of the step [s].
     * @param next_frame  [s], later than that.
     * @throw InputError  if the fixed step is beyond a limit at the start of a run.
     * @throw RunError    if it is so in the course of it.
     */
    TimeStep
    next_step(const StepConditions &conditions, const double time, const double next_frame) const;

  private:
    /** Without regard to frames. */
    TimeStep
    stable_step(const StepConditions &conditions) const;

    /** The fixed step, unless it is refused. */
    TimeStep
    fixed_step(const StepConditions &conditions, const double time) const;

    const TimeStepParameters parameters;
    const double lattice_spacing;
  };
} // namespace magmpm
