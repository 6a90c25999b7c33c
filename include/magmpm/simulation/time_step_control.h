#pragma once

#include <magmpm/coupling/step_conditions.h>
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
    std::string limit =
      "none"; ///< elastic, viscous, force, affine, capillary, rotation, maximum, frame end or fixed
  };

  /**
   * Chooses the length of each time step: symplectic Euler is stable and particles stay close to
   * their blocks if no signal crosses more than a fraction of a cell.
   *
   *   elastic:  dt <= elastic factor dx/(c + |v|), c with the magnetic waves
   *   viscous:  dt <= viscous factor dx^2/(J mu_N/rho_0)
   *   force:    dt <= force factor sqrt(dx/|a|)
   *   affine:   dt <= affine factor/|C|
   *   capillary: dt <= capillary factor sqrt(rho dx^3/gamma)
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
