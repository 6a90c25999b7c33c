#pragma once

#include <cstddef>
#include <vector>

namespace magmpm::paper_scheme
{
  /**
   * A number on every node. Two layers of zeros beyond either end let stencils that reach over the
   * faces of the box read without asking; their coefficients there are zero.
   */
  class NodeVector
  {
  public:
    /** Zeros on @p size nodes, and @p padding more at both ends. */
    void
    reinit(const std::ptrdiff_t size, const std::ptrdiff_t padding)
    {
      n_nodes   = size;
      n_padding = padding;
      values.assign(size + 2 * padding, 0.);
    }

    /** Zeros, of the shape of @p other. */
    void
    reinit(const NodeVector &other)
    {
      reinit(other.n_nodes, other.n_padding);
    }

    std::ptrdiff_t
    size() const
    {
      return n_nodes;
    }

    double *
    data()
    {
      return values.data() + n_padding;
    }

    const double *
    data() const
    {
      return values.data() + n_padding;
    }

    double &
    operator[](const std::ptrdiff_t node)
    {
      return data()[node];
    }

    double
    operator[](const std::ptrdiff_t node) const
    {
      return data()[node];
    }

    void
    add(const double factor, const NodeVector &other);

    double
    l2_norm() const;

  private:
    std::ptrdiff_t n_nodes   = 0;
    std::ptrdiff_t n_padding = 0;
    std::vector<double> values;
  };
} // namespace magmpm::paper_scheme
