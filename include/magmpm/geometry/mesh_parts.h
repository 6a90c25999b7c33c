#pragma once

#include <magmpm/geometry/triangle_mesh.h>

namespace magmpm
{
  /**
   * Turns the triangles of a closed mesh outward, whichever way each of them was: the corners then go
   * counterclockwise seen from outside of the material. A connected part inside another is a cavity,
   * a part inside that one is full again.
   *
   * That a surface does not cross itself is not checked; that parts do not cross each other is, at
   * their corners.
   *
   * @throw InputError  if parts cross, or if a part has only one side (as a Klein bottle).
   */
  void
  turn_outward(TriangleMesh &mesh);
} // namespace magmpm
