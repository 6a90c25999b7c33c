#pragma once

#include <magmpm/geometry/shape.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/motion/pose.h>
#include <magmpm/particles/body.h>

#include <algorithm>
#include <cstddef>

namespace magmpm
{
  /** No particle is pushed further in a call of hold_outside(), in dx: it may leave its arena. */
  inline constexpr double largest_push = 0.1;

  /** What hold_outside() found and did. */
  template <int dim>
  struct RigidHold
  {
    std::size_t n_inside = 0;  ///< particles inside the shape
    std::size_t n_held   = 0;  ///< of these, those that were put back
    double deepest       = 0.; ///< of a particle before it was put back [m]

    /** What the particles lost: momentum [N s], and angular momentum about the origin of the pose [N m s]. */
    Vector<dim> impulse;
    Vector<n_axial_components<dim>> angular_impulse;

    /** Those that add up over ranks. */
    template <typename F>
    void
    for_each_number(F &&f)
    {
      f(n_inside);
      f(n_held);
      f(impulse);
      f(angular_impulse);
    }

    RigidHold &
    operator+=(const RigidHold &other)
    {
      n_inside += other.n_inside;
      n_held += other.n_held;
      deepest = std::max(deepest, other.deepest);
      impulse += other.impulse;
      angular_impulse += other.angular_impulse;
      return *this;
    }
  };

  /**
   * Puts particles that are deeper inside a rigid shape than @p tolerated_depth back to that depth, or
   * as far towards it as largest_push allows, and takes from them the part of their velocity, relative to the shape, that goes further in.
   *
   * The lattice alone does not hold them: its velocity at the surface is an average over nodes, not
   * all of which are inside. How far in a particle may be is for the caller to say: material that
   * was pressed against a surface lies within a fraction of a cell of it on either side.
   *
   * @param pose    of the frame of the shape.
   * @param motion  of that frame.
   */
  template <int dim>
  RigidHold<dim>
  hold_outside(const BlockSet<dim> &blocks,
               const Lattice<dim> &lattice,
               const Shape<dim> &shape,
               const Pose<dim> &pose,
               const RigidMotion<dim> &motion,
               const double tolerated_depth,
               Body<dim> &body);
} // namespace magmpm
