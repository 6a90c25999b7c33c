#pragma once

#include <magmpm/lattice/lattice.h>

#include <cmath>

namespace magmpm
{
  template <int dim>
  struct Ball
  {
    Vector<dim> centre;
    double radius; ///< [m]
  };

  template <int dim>
  inline bool
  overlap(const Ball<dim> &a, const Ball<dim> &b)
  {
    return norm_square(a.centre - b.centre) < (a.radius + b.radius) * (a.radius + b.radius);
  }

  /** The ball around the places that particles of a block can have between two sorts. */
  template <int dim>
  inline Ball<dim>
  reach_of_block(const Lattice<dim> &lattice, const Index<dim> &block)
  {
    // Base nodes 0 .. 3, so positions from 0.5 to 4.5 dx, and a drift of one cell on every side.
    Ball<dim> ball = {Vector<dim>(),
                      (0.5 * block_edge + 1.) * lattice.spacing *
                        std::sqrt(static_cast<double>(dim))};
    for (int d = 0; d < dim; ++d)
      ball.centre[d] = lattice.lower_corner[d] +
                       (block_edge * block[d] + 0.5 * (block_edge + 1)) * lattice.spacing;
    return ball;
  }
} // namespace magmpm
