#pragma once

#include <magmpm/boundary/rigid_body.h>
#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>

#include <vector>

namespace magmpm
{
  /** How far a B-spline reaches from its node, in dx. */
  inline constexpr double bspline_reach = 1.5;

  /**
   * The part of a node's B-spline that lies in a body, as if its surface were plane, of a node at the signed
   * distance t dx from it:
   *   s(t) = 1/2 - 3t/4 + t^3/3 (0 < t < 1/2),   (3/2 - t)^3/6 (1/2 < t < 3/2),   s(-t) = 1 - s(t).
   */
  double
  share_inside(const double t);

  /** Adds to owned nodes the part of their B-spline that lies in rigid bodies with a surface. */
  template <int dim>
  void
  add_share_in_bodies(const std::vector<RigidBody<dim>> &bodies,
                      const BlockSet<dim> &blocks,
                      const Lattice<dim> &lattice,
                      NodeField<dim, SingleScalar> &fraction);
} // namespace magmpm
