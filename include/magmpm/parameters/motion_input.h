#pragma once

#include <magmpm/motion/key_frames.h>
#include <magmpm/parameters/parameter_register.h>

#include <string>

namespace magmpm
{
  /** How the user says that something moves, before it is a TimeFunction. */
  struct MotionInput
  {
    std::string position, rotation; ///< expressions
    std::string key_frames;         ///< instead of these: a table, or the name of a file
    KeyFrameInterpolation interpolation = KeyFrameInterpolation::linear;
  };

  /**
   * The key frames of @p input, which the parameter @p path gives. A file is looked for beside the
   * parameter file, then in the working directory.
   *
   * @throw InputError  if there are none, or wrong ones; names the line.
   */
  template <int dim>
  KeyFrames<dim>
  read_key_frames(const ParameterRegister &declarations,
                  const std::string &path,
                  const MotionInput &input);
} // namespace magmpm
