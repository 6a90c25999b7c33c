#pragma once

#include <magmpm/base/simd.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/lattice.h>

namespace magmpm
{
  /** The four lanes of a node. */
  using NodeLanes = Simd<double, n_lanes>;

  /** Three nodes in a row along x: a row of the stencil of a quadratic B-spline. */
  struct NodeRow
  {
    NodeLanes nodes[stencil_width] = {};

    static NodeRow
    load(const double *address)
    {
      NodeRow row;
      for (int i = 0; i < stencil_width; ++i)
        row.nodes[i] = NodeLanes::load(address + i * n_lanes);
      return row;
    }

    /** Adds the row to what is there. */
    void
    add_to(double *address) const
    {
      for (int i = 0; i < stencil_width; ++i)
        (NodeLanes::load(address + i * n_lanes) + nodes[i]).store(address + i * n_lanes);
    }

    /** Adds @p factor times another row. */
    void
    add(const NodeLanes &factor, const NodeRow &row)
    {
      for (int i = 0; i < stencil_width; ++i)
        nodes[i] += factor * row.nodes[i];
    }

    NodeRow &
    operator+=(const NodeRow &row)
    {
      for (int i = 0; i < stencil_width; ++i)
        nodes[i] += row.nodes[i];
      return *this;
    }
  };

  inline NodeRow
  operator*(const NodeRow &row, const NodeLanes &lanes)
  {
    NodeRow product;
    for (int i = 0; i < stencil_width; ++i)
      product.nodes[i] = row.nodes[i] * lanes;
    return product;
  }
} // namespace magmpm
