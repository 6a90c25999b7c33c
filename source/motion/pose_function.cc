#include <magmpm/motion/pose_function.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Half the interval of the difference quotient of motion_at() [s]. */
    constexpr double half_interval = 1e-6;

    /** The rotation vector of a rotation by less than a quarter turn. */
    template <int dim>
    Vector<n_axial_components<dim>>
    small_rotation_vector(const Matrix<dim> &rotation)
    {
      // The antisymmetric part is the axis times the sine.
      Vector<n_axial_components<dim>> result;
      if constexpr (dim == 3)
        result = {{0.5 * (rotation(2, 1) - rotation(1, 2)),
                   0.5 * (rotation(0, 2) - rotation(2, 0)),
                   0.5 * (rotation(1, 0) - rotation(0, 1))}};
      else
        result[0] = 0.5 * (rotation(1, 0) - rotation(0, 1));
      const double sine = norm(result);
      return sine > 1e-8 ? (std::asin(std::min(sine, 1.)) / sine) * result : result;
    }
  } // namespace

  template <int dim>
  TimeFunction<Pose<dim>>
  pose_function(const TimeFunction<Vector<dim>> &position,
                const TimeFunction<Vector<n_axial_components<dim>>> &rotation)
  {
    const auto pose = [position, rotation](const double time) {
      return Pose<dim>{position(time), rotation_by<dim>(rotation(time))};
    };
    if (position.is_constant() && rotation.is_constant())
      return pose(0.);
    return TimeFunction<Pose<dim>>(pose);
  }

  template <int dim>
  RigidMotion<dim>
  motion_at(const TimeFunction<Pose<dim>> &pose, const double time)
  {
    if (pose.is_constant())
      return {};
    const double middle      = std::max(time, half_interval);
    const double before      = middle - half_interval;
    const double after       = middle + half_interval;
    const double per_second  = 1. / (after - before);
    const Pose<dim> old_pose = pose(before), new_pose = pose(after);
    return {per_second * (new_pose.position - old_pose.position),
            per_second *
              small_rotation_vector<dim>(new_pose.rotation * transpose(old_pose.rotation))};
  }

#define MAGMPM_INSTANTIATE(dim)                                                                \
  template TimeFunction<Pose<dim>> pose_function(                                              \
    const TimeFunction<Vector<dim>> &, const TimeFunction<Vector<n_axial_components<dim>>> &); \
  template RigidMotion<dim> motion_at(const TimeFunction<Pose<dim>> &, double);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
#undef MAGMPM_INSTANTIATE
} // namespace magmpm
