#pragma once

#include <magmpm/lattice/lattice.h>

#include <cstddef>

namespace magmpm::paper_scheme
{
  /**
   * The uniform grid over the whole potential box, on whose nodes everything lives. Nodes are
   * numbered with x fastest; a line is a row of nodes along x.
   */
  template <int dim>
  struct NodeGrid : Lattice<dim>
  {
    NodeGrid(const Vector<dim> &lower_corner, const Index<dim> &n_nodes, const double spacing)
    {
      this->lower_corner = lower_corner;
      this->spacing      = spacing;
      for (int a = 0; a < dim; ++a)
        this->n_cells[a] = n_nodes[a] - 1;
    }

    int
    n_nodes(const int axis) const
    {
      return this->n_cells[axis] + 1;
    }

    /** Distance of the numbers of two neighbours along an axis. */
    std::ptrdiff_t
    stride(const int axis) const
    {
      std::ptrdiff_t product = 1;
      for (int a = 0; a < axis; ++a)
        product *= n_nodes(a);
      return product;
    }

    std::ptrdiff_t
    size() const
    {
      return stride(dim);
    }

    int
    n_lines() const
    {
      return static_cast<int>(size() / n_nodes(0));
    }

    std::ptrdiff_t
    number(const Index<dim> &node) const
    {
      std::ptrdiff_t result = 0;
      for (int a = 0; a < dim; ++a)
        result += node[a] * stride(a);
      return result;
    }

    Index<dim>
    node(std::ptrdiff_t number) const
    {
      Index<dim> result;
      for (int a = 0; a < dim; ++a, number /= n_nodes(a - 1))
        result[a] = static_cast<int>(number % n_nodes(a));
      return result;
    }
  };
} // namespace magmpm::paper_scheme
