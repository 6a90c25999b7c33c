#pragma once

#include <magmpm/geometry/triangle_mesh.h>

#include <string>

namespace magmpm
{
  /**
   * Reads a closed mesh: STL, OBJ or PLY by the name's end, polygons cut into triangles, corners in
   * the same place made one, all triangles turned outward (turn_outward()). Each rank that needs the
   * mesh reads the file.
   *
   * @throw InputError  if the file cannot be read, has no triangles or is not closed, or if its parts
   *                    cross; the message begins with the name of the file and says what to do.
   */
  TriangleMesh
  read_closed_mesh(const std::string &file);
} // namespace magmpm
