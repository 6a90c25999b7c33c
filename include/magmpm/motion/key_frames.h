#pragma once

#include <magmpm/motion/pose.h>
#include <magmpm/motion/time_function.h>

#include <string>

namespace magmpm
{
  /** How a thing goes from one key frame to the next. */
  enum class KeyFrameInterpolation
  {
    linear, ///< at a constant velocity
    smooth  ///< from rest to rest
  };

  /** Whether @p text is the rows themselves, and not the name of a file: whether it begins with a number. */
  bool
  is_key_frame_table(const std::string &text);

  /** Pose and strength (a factor) as key frames give them. */
  template <int dim>
  struct KeyFrames
  {
    TimeFunction<Pose<dim>> pose;
    TimeFunction<double> strength;
  };

  /**
   * Poses and strengths at given times, and those between: position and strength on a straight line,
   * the rotation about one axis by the shorter way (slerp). The way is covered at a constant velocity
   * (linear), or with 3 s^2 - 2 s^3 of it done after the part s of the time (smooth), at rest in each
   * key frame. Before the first and after the last one nothing moves. What is the same in all of them
   * is constant.
   *
   * A row is: time [s], position [m] (dim numbers), rotation as axis times angle [rad] (3 numbers, in 2D
   * 1), strength (a factor); strength, or rotation and strength, may be left out in all rows, which then
   * are 1 and no rotation. Numbers are separated by commas. In a file each row is a line; empty lines,
   * lines that begin with #, and a first line of headings do not count. In the parameter file rows are
   * separated by semicolons.
   *
   * @param table       the rows, if it begins with a number; else the name of a file.
   * @param subject     what is given by them, for messages: "Key frames of source 'ball'".
   * @throw InputError  if the file cannot be read, a row does not have the right number of numbers, or
   *                    times do not increase; names subject, row and value.
   */
  template <int dim>
  KeyFrames<dim>
  read_key_frames(const std::string &table,
                  const KeyFrameInterpolation interpolation,
                  const std::string &subject);
} // namespace magmpm
