#pragma once

#include <magmpm/base/tensor.h>

namespace magmpm::verification
{
  /**
   * Mean magnetization over the outer field, M/H_0, of a linear block in a uniform field along its last
   * axis: a cuboid, in 2D a bar (infinitely long across the plane) or, axisymmetric, a round disc or rod
   * with the field along its axis of rotation.
   *
   * Finite elements FE_Q(2) of deal.II on a quarter (an eighth) of the block and of the space around it,
   * whose cells follow the faces and grow with the distance from the edges, where the field is singular.
   * Apart from deal.II nothing here is shared with magmpm. Good to 1e-3 with the cells of the default, as
   * block_reference.cc of tests/verification shows.
   *
   * @param half_axes       of the block, in any unit; of a round one its radius and half its length.
   * @param susceptibility  chi.
   * @param axisymmetric    with dim = 2: rotates about the last axis.
   * @param n_cells         along half an axis of the block.
   */
  template <int dim>
  double
  magnetization_of_block(const Vector<dim> &half_axes,
                         const double susceptibility,
                         const bool axisymmetric = false,
                         const int n_cells       = (dim == 2 ? 14 : 8));
} // namespace magmpm::verification
