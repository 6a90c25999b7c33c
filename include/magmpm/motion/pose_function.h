#pragma once

#include <magmpm/motion/pose.h>
#include <magmpm/motion/time_function.h>

namespace magmpm
{
  /**
   * Where a rigid thing goes and how it turns.
   *
   * @param rotation  axis times angle [rad]; in 2D the angle.
   */
  template <int dim>
  TimeFunction<Pose<dim>>
  pose_function(const TimeFunction<Vector<dim>> &position,
                const TimeFunction<Vector<n_axial_components<dim>>> &rotation = {});

  /**
   * How a pose changes at @p time >= 0 [s], by its central difference over time +- 1e-6 s (at earlier
   * times than that, over 0 to 2e-6 s). For a position A sin(w t) the relative error is below
   * (1e-6 s w)^2/6 but for rounding, about 1e-10/s of the value; a jump counts as a steep ramp.
   */
  template <int dim>
  RigidMotion<dim>
  motion_at(const TimeFunction<Pose<dim>> &pose, const double time);
} // namespace magmpm
