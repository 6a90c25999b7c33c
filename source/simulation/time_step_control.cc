#include <magmpm/base/exceptions.h>
#include <magmpm/simulation/time_step_control.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace magmpm
{
  namespace
  {
    /** Of material and of rigid bodies [m/s^2]. */
    double
    max_acceleration(const StepConditions &conditions)
    {
      return std::max(conditions.acceleration, conditions.rigid_acceleration);
    }

    /** What a limit is made of, for a message. */
    std::string
    formula_of(const std::string &limit, const StepConditions &conditions)
    {
      std::ostringstream text;
      if (limit == "elastic")
        text << "Elastic factor times dx/(c + |v|), c + |v| = " << conditions.signal_speed
             << " m/s, and " << conditions.magnetic_wave_speed
             << " m/s of magnetic waves; a magnet "
             << "moves at " << conditions.collider_speed << " m/s";
      else if (limit == "viscous")
        text << "Viscous factor times rho dx^2/mu_N, mu_N/rho = " << conditions.kinematic_viscosity
             << " m^2/s";
      else if (limit == "force")
        text << "Force factor times sqrt(dx/|a|), |a| = " << max_acceleration(conditions)
             << " m/s^2";
      else if (limit == "capillary")
        text << "Capillary factor times sqrt(rho dx^3/gamma), which is "
             << 1. / conditions.capillary_rate << " s";
      else if (limit == "rotation")
        text << "Affine factor over the rate at which a free rigid body turns or swings, "
             << conditions.rotation_rate << " 1/s";
      else
        text << "Affine factor over |C|, |C| = " << conditions.affine_velocity << " 1/s";
      return text.str();
    }
  } // namespace

  TimeStepControl::TimeStepControl(const TimeStepParameters &parameters,
                                   const double lattice_spacing)
    : parameters(parameters)
    , lattice_spacing(lattice_spacing)
  {
  }

  TimeStep
  TimeStepControl::stable_step(const StepConditions &conditions) const
  {
    TimeStep step    = {parameters.maximum, "maximum"};
    const auto limit = [&step](const std::string &name, const double length) {
      if (length < step.length)
        step = {length, name};
    };
    const double dx    = lattice_spacing;
    const double speed = conditions.signal_speed + conditions.magnetic_wave_speed;
    limit("elastic", parameters.elastic_factor * dx / std::max(speed, conditions.collider_speed));
    limit("viscous", parameters.viscous_factor * dx * dx / conditions.kinematic_viscosity);
    limit("force", parameters.force_factor * std::sqrt(dx / max_acceleration(conditions)));
    limit("affine", parameters.affine_factor / conditions.affine_velocity);
    limit("capillary", parameters.capillary_factor / conditions.capillary_rate);
    limit("rotation", parameters.affine_factor / conditions.rotation_rate);
    return step;
  }

  TimeStep
  TimeStepControl::fixed_step(const StepConditions &conditions, const double time) const
  {
    const TimeStep limit = stable_step(conditions);
    // A user who takes the limit that a message printed has it to six digits.
    if (parameters.allow_unstable || parameters.fixed_step <= (1. + 1e-5) * limit.length)
      return {parameters.fixed_step, "fixed"};

    std::ostringstream message;
    message
      << "at t = " << time << " s the given Time step/Time step (" << parameters.fixed_step
      << " s) is longer than the " << limit.limit << " limit, " << limit.length
      << " s: " << formula_of(limit.limit, conditions)
      << ". Take 'Time step = auto' or a shorter one in the section 'Time step', or, for a run "
         "that may go astray, 'Allow unstable time step = true'.";
    if (time > 0.)
      throw RunError(message.str());
    throw InputError(message.str());
  }

  TimeStep
  TimeStepControl::next_step(const StepConditions &conditions,
                             const double time,
                             const double next_frame) const
  {
    const bool is_fixed        = parameters.fixed_step > 0.;
    const double time_to_frame = next_frame - time;
    TimeStep step = (is_fixed ? fixed_step(conditions, time) : stable_step(conditions));
    // Meet the frame, and without a sliver of a step before it. A fixed step that divides the frame
    // interval, up to rounding, stays what it is.
    if (step.length >= (1. - 1e-9) * time_to_frame)
      {
        if (step.length > (1. + 1e-9) * time_to_frame)
          step.limit = frame_end_limit;
        step.length = time_to_frame;
      }
    else if (!is_fixed && 2. * step.length > time_to_frame)
      step = {0.5 * time_to_frame, frame_end_limit};
    return step;
  }
} // namespace magmpm
