#pragma once

#include <magmpm/geometry/shape.h>

namespace magmpm
{
  /** Points of a file, in its order. */
  template <int dim>
  struct PointCloud
  {
    std::vector<Vector<dim>> points; ///< [m]
    std::vector<double> volumes;     ///< [m^3], in 2D [m^2]; empty if the file has none
    std::vector<int> lines;          ///< of the file, from 1
  };

  /**
   * Reads points from a text file, one a line: x, y, z and, in all lines or none, a volume [m, m^3];
   * in 2D x, y and an area. Numbers are separated by commas. Empty lines and those that begin with #
   * are skipped, and so is a first line that does not begin with a number, the heading. The points are
   * then scaled, rotated and translated.
   *
   * @throw InputError  if the file cannot be read or has no points, or if a line is not understood;
   *                    the message begins with the name of the file and the line.
   */
  template <int dim>
  PointCloud<dim>
  read_point_cloud(const ShapeParameters<dim> &parameters);
} // namespace magmpm
