#pragma once

#include <magmpm/motion/pose.h>
#include <magmpm/motion/key_frames.h>
#include <magmpm/motion/motion_script.h>
#include <magmpm/magnets/source_parameters.h>

#include <optional>

namespace magmpm
{
  /** Where a source goes, how it turns, and how its strength changes: by expressions or key frames. */
  template <int dim>
  class SourceMotion
  {
  public:
    /**
     * @throw InputError  if an expression or the key frames cannot be read, or both are given; names
     *                    source and parameter.
     */
    explicit SourceMotion(const SourceParameters<dim> &parameters);

    /** @param time  >= 0 [s]. */
    Pose<dim>
    pose(const double time) const;

    /**
     * How the pose changes, by its central difference over time +- 1e-6 s (at earlier times than that,
     * over 0 to 2e-6 s). For a position A sin(w t) the relative error is below (1e-6 s w)^2/6 but for
     * rounding, about 1e-10/s of the value; a jump counts as a steep ramp.
     */
    RigidMotion<dim>
    motion(const double time) const;

    /** Factor of the source's magnetization, moment or current. */
    double
    strength(const double time) const;

    bool
    pose_is_constant() const;

    bool
    strength_is_constant() const;

  private:
    std::optional<KeyFrames<dim>> key_frames;
    std::optional<MotionScript<dim>> position_script;
    std::optional<MotionScript<n_axial_components<dim>>> rotation_script;
    std::optional<MotionScript<1>> strength_script;
  };
} // namespace magmpm
