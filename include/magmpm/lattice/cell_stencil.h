#pragma once

#include <magmpm/lattice/node_field.h>
#include <magmpm/lattice/node_window.h>

#include <array>

namespace magmpm
{
  /** Lattice nodes whose B-splines reach into a mesh cell of edge 2 dx: -1 .. 3 per axis (dx: -1 .. 2). */
  inline constexpr int stencil_edge = 5;
  template <int dim>
  inline constexpr int n_stencil_nodes = power(stencil_edge, dim);

  /** Four lanes on each of @p n places, named as those of a field. */
  template <int n>
  struct LaneArray : public std::array<double, n * n_lanes>
  {
    template <typename Quantities>
    double
    get(const NodeScalar<Quantities> quantity, const int i) const
    {
      return (*this)[i * n_lanes + quantity.lane];
    }

    template <typename Quantities>
    void
    set(const NodeScalar<Quantities> quantity, const int i, const double value)
    {
      (*this)[i * n_lanes + quantity.lane] = value;
    }

    template <int dim, typename Quantities>
    void
    set(const NodeVector<Quantities> quantity, const int i, const Vector<dim> &vector)
    {
      std::copy_n(vector.values, dim, this->data() + i * n_lanes + quantity.lane);
    }
  };

  /** On the nodes of the stencil, x fastest. */
  template <int dim>
  using StencilValues = LaneArray<n_stencil_nodes<dim>>;

  /**
   * Reads up to four lanes of the nodes around a mesh cell. Nodes of blocks that are not active count as
   * zero, as lanes do that the field has not.
   *
   * @param slot    of the cell's block.
   * @param corner  the cell's lower node within the block: 0 .. 3 per axis.
   */
  template <int dim>
  void
  gather_stencil(const NodeNumbers<dim> &field,
                 const BlockSet<dim> &blocks,
                 const int slot,
                 const Index<dim> &corner,
                 StencilValues<dim> &values);

  /** Adds the lanes of the field to the nodes around a cell, apart from those that are not active. */
  template <int dim>
  void
  scatter_stencil(const StencilValues<dim> &values,
                  const BlockSet<dim> &blocks,
                  const int slot,
                  const Index<dim> &corner,
                  NodeNumbers<dim> &field);
} // namespace magmpm
