#include <magmpm/base/exceptions.h>
#include <magmpm/motion/source_motion.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Half the interval of the difference quotient of motion() [s]. */
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
  SourceMotion<dim>::SourceMotion(const SourceParameters<dim> &parameters)
  {
    const std::string of = " of source '" + parameters.name + "'";
    if (!parameters.key_frames.empty())
      {
        if (!parameters.position.empty() || !parameters.rotation.empty() ||
            !parameters.strength.empty())
          throw InputError("Source '" + parameters.name +
                           "' has key frames and expressions of its motion. Give either the key "
                           "frames, or position, rotation and strength.");
        key_frames.emplace(parameters.key_frames, parameters.interpolation, "Key frames" + of);
        return;
      }
    position_script.emplace(parameters.position, "Position" + of);
    if (!parameters.rotation.empty())
      rotation_script.emplace(parameters.rotation, "Rotation" + of);
    if (!parameters.strength.empty())
      strength_script.emplace(parameters.strength, "Strength" + of);
  }

  template <int dim>
  Pose<dim>
  SourceMotion<dim>::pose(const double time) const
  {
    if (key_frames)
      return key_frames->pose(time);
    Pose<dim> pose;
    pose.position = position_script->value(time);
    if (rotation_script)
      pose.rotation = rotation_by<dim>(rotation_script->value(time));
    return pose;
  }

  template <int dim>
  RigidMotion<dim>
  SourceMotion<dim>::motion(const double time) const
  {
    if (pose_is_constant())
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

  template <int dim>
  double
  SourceMotion<dim>::strength(const double time) const
  {
    if (key_frames)
      return key_frames->strength(time);
    return strength_script ? strength_script->value(time)[0] : 1.;
  }

  template <int dim>
  bool
  SourceMotion<dim>::pose_is_constant() const
  {
    if (key_frames)
      return key_frames->pose_is_constant();
    return position_script->is_constant() && (!rotation_script || rotation_script->is_constant());
  }

  template <int dim>
  bool
  SourceMotion<dim>::strength_is_constant() const
  {
    if (key_frames)
      return key_frames->strength_is_constant();
    return !strength_script || strength_script->is_constant();
  }

  template class SourceMotion<2>;
  template class SourceMotion<3>;
} // namespace magmpm
