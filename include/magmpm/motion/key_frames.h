#pragma once

#include <magmpm/motion/pose.h>
#include <magmpm/magnets/source_parameters.h>

#include <string>
#include <vector>

namespace magmpm
{
  /** Whether @p text is the rows themselves, and not the name of a file: whether it begins with a number. */
  bool
  is_key_frame_table(const std::string &text);

  /**
   * Poses and strengths at given times, and those between: position and strength on a straight line,
   * the rotation about one axis by the shorter way (slerp). The way is covered at a constant velocity
   * (linear), or with 3 s^2 - 2 s^3 of it done after the part s of the time (smooth), at rest in each
   * key frame. Before the first and after the last one nothing moves.
   *
   * A row is: time [s], position [m] (dim numbers), rotation as axis times angle [rad] (3 numbers, in 2D
   * 1), strength (a factor); strength, or rotation and strength, may be left out in all rows, which then
   * are 1 and no rotation. Numbers are separated by commas. In a file each row is a line; empty lines,
   * lines that begin with #, and a first line of headings do not count. In the parameter file rows are
   * separated by semicolons.
   */
  template <int dim>
  class KeyFrames
  {
  public:
    /**
     * @param table       the rows, if it begins with a number; else the name of a file.
     * @param subject     what is given by them, for messages: "Key frames of source 'ball'".
     * @throw InputError  if the file cannot be read, a row does not have the right number of numbers, or
     *                    times do not increase; names subject, row and value.
     */
    KeyFrames(const std::string &table,
              const KeyFrameInterpolation interpolation,
              const std::string &subject);

    Pose<dim>
    pose(const double time) const;

    double
    strength(const double time) const;

    bool
    pose_is_constant() const;

    bool
    strength_is_constant() const;

  private:
    struct Row
    {
      double time;
      Pose<dim> pose;
      double strength;
    };

    /** The row before @p time and how much of the way to the next one is done, 0 to 1. */
    std::pair<std::size_t, double>
    place(const double time) const;

    std::vector<Row> rows;
    KeyFrameInterpolation interpolation;
  };
} // namespace magmpm
