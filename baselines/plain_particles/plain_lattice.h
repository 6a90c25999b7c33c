#pragma once

#include <magmpm/lattice/lattice.h>

#include <vector>

namespace magmpm::baselines
{
  /** A node: its momentum [kg m/s], or its velocity [m/s], and its mass [kg]. */
  template <int dim>
  struct PlainNode
  {
    Vector<dim> motion;
    double mass = 0.;
  };

  /** All nodes of a box of the lattice in one array, x fastest. */
  template <int dim>
  class PlainLattice
  {
  public:
    /** Nodes @p lower to @p upper, both in the box, all of them zero. */
    void
    reinit(const Index<dim> &lower, const Index<dim> &upper)
    {
      first           = lower;
      std::size_t all = 1;
      for (int d = 0; d < dim; ++d)
        {
          count[d]   = upper[d] - lower[d] + 1;
          strides[d] = all;
          all *= count[d];
        }
      nodes.assign(all, PlainNode<dim>());
    }

    std::size_t
    size() const
    {
      return nodes.size();
    }

    std::size_t
    stride(const int d) const
    {
      return strides[d];
    }

    /** Node number @p n, 0 to size() - 1. */
    PlainNode<dim> &
    operator[](const std::size_t n)
    {
      return nodes[n];
    }

    const PlainNode<dim> &
    operator[](const std::size_t n) const
    {
      return nodes[n];
    }

    std::size_t
    number(const Index<dim> &node) const
    {
      std::size_t n = 0;
      for (int d = 0; d < dim; ++d)
        n += (node[d] - first[d]) * strides[d];
      return n;
    }

    Index<dim>
    node(const std::size_t n) const
    {
      Index<dim> node;
      for (int d = 0; d < dim; ++d)
        node[d] = first[d] + static_cast<int>(n / strides[d] % count[d]);
      return node;
    }

    bool
    contains(const Index<dim> &node) const
    {
      bool inside = true;
      for (int d = 0; d < dim; ++d)
        inside = inside && node[d] >= first[d] && node[d] < first[d] + static_cast<int>(count[d]);
      return inside;
    }

  private:
    Index<dim> first                     = {};
    std::array<std::size_t, dim> count   = {};
    std::array<std::size_t, dim> strides = {};
    std::vector<PlainNode<dim>> nodes;
  };
} // namespace magmpm::baselines
