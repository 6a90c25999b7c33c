#include <magmpm/time_step_control.h>

#include <cmath>

namespace magmpm
{
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
    limit("force", parameters.force_factor * std::sqrt(dx / conditions.acceleration));
    limit("affine", parameters.affine_factor / conditions.affine_velocity);
    return step;
  }

  TimeStep
  TimeStepControl::next_step(const StepConditions &conditions, const double time_to_frame) const
  {
    TimeStep step = (parameters.adaptive ? stable_step(conditions)
                                         : TimeStep{parameters.fixed_step, "fixed"});
    // Meet the frame, and without a sliver of a step before it. A fixed step that divides the frame
    // interval, up to rounding, stays what it is.
    if (step.length >= (1. - 1e-9) * time_to_frame)
      {
        if (step.length > (1. + 1e-9) * time_to_frame)
          step.limit = frame_end_limit;
        step.length = time_to_frame;
      }
    else if (parameters.adaptive && 2. * step.length > time_to_frame)
      step = {0.5 * time_to_frame, frame_end_limit};
    return step;
  }
} // namespace magmpm
