#include <baselines/paper_scheme/incomplete_cholesky.h>

#include <algorithm>

namespace magmpm::paper_scheme
{
  namespace
  {
    /**
     * z_i += c_i z_(i-2) for i = 2 .. n-1, counted along @p direction: two chains, one of each
     * parity, which the processor follows at the same time.
     */
    inline void
    follow_chain(const int n, const double *c, double *z, const int direction)
    {
      double even = z[0], odd = z[direction];
      for (int i = 2; i + 1 < n; i += 2)
        {
          const int j = direction * i, k = j + direction;
          even = z[j] + c[j] * even;
          odd  = z[k] + c[k] * odd;
          z[j] = even;
          z[k] = odd;
        }
      if (n % 2 == 1)
        z[direction * (n - 1)] += c[direction * (n - 1)] * even;
    }
  } // namespace

  template <int dim>
  IncompleteCholesky<dim>::IncompleteCholesky(const NodeGrid<dim> &grid)
    : grid(grid)
    , chain(grid.n_nodes(0))
  {
    inverse.reinit(grid.size(), 2 * grid.stride(dim - 1));
  }

  template <int dim>
  void
  IncompleteCholesky<dim>::reinit(const PotentialStencil<dim> &jacobian, const double modification)
  {
    rows = &jacobian.coefficients();
    NodeVector diagonal;
    diagonal.reinit(inverse);
    jacobian.compute_diagonal(diagonal);

    for (int line = 0; line < grid.n_lines(); ++line)
      factorize_line(line, modification, diagonal);
  }

  template <int dim>
  void
  IncompleteCholesky<dim>::factorize_line(const std::ptrdiff_t line,
                                          const double modification,
                                          const NodeVector &diagonal_vector)
  {
    constexpr double smallest    = 0.25;
    const int n                  = grid.n_nodes(0);
    const Index<dim> node        = grid.node(line * n);
    const double *const diagonal = diagonal_vector.data() + line * n;
    double *const d              = inverse.data() + line * n;
    double *const pivot          = chain.data();

    // Of the neighbour 2 dx below along an axis, the entries above along the others are the fill.
    std::copy(diagonal, diagonal + n, pivot);
    for (int a = 1; a < dim; ++a)
      {
        if (node[a] < 2)
          continue;
        const std::ptrdiff_t below     = line - 2 * rows->line_stride(a);
        const std::ptrdiff_t step      = 2 * grid.stride(a);
        const double *const w          = rows->row(a, line - rows->line_stride(a));
        const double *const fill_x     = rows->row(0, below);
        const int other                = dim == 2 ? 0 : 3 - a;
        const double *const fill_other = dim == 2
                                           ? nullptr
                                           : rows->row(other, below + rows->line_stride(other));
#pragma omp simd
        for (int i = 0; i < n; ++i)
          {
            double fill = fill_x[i + 1];
            if constexpr (dim == 3)
              fill += fill_other[i];
            pivot[i] -= w[i] * (w[i] + modification * fill) * d[i - step];
          }
      }

    const double *const w = rows->row(0, line);
    for (int i = 0; i < n; ++i)
      {
        double fill = 0.;
        if (i > 1)
          for (int a = 1; a < dim; ++a)
            fill += rows->row(a, line + rows->line_stride(a))[i - 2];
        if (i > 1)
          pivot[i] -= w[i - 1] * (w[i - 1] + modification * fill) * d[i - 2];
        d[i] = 1. / (pivot[i] < smallest * diagonal[i] ? diagonal[i] : pivot[i]);
      }
  }

  template <int dim>
  void
  IncompleteCholesky<dim>::substitute_forward(const NodeVector &r_vector,
                                              NodeVector &z_vector) const
  {
    const int n = grid.n_nodes(0);
    for (int line = 0; line < grid.n_lines(); ++line)
      {
        const std::ptrdiff_t first = std::ptrdiff_t(line) * n;
        const double *const r      = r_vector.data() + first;
        const double *const d      = inverse.data() + first;
        const double *const row    = rows->row(0, line);
        double *const z            = z_vector.data() + first;
        double *const c            = chain.data();
        const double *below[dim];
        std::ptrdiff_t step[dim];
        for (int a = 1; a < dim; ++a)
          {
            below[a] = rows->row(a, line - rows->line_stride(a));
            step[a]  = 2 * grid.stride(a);
          }
          // Everything but the recurrence along the line first: that part is vectorized.
#pragma omp simd
        for (int i = 0; i < n; ++i)
          {
            double sum = r[i];
            for (int a = 1; a < dim; ++a)
              sum += below[a][i] * z[i - step[a]];
            z[i] = d[i] * sum;
            c[i] = d[i] * row[i - 1];
          }
        follow_chain(n, c, z, 1);
      }
  }

  template <int dim>
  double
  IncompleteCholesky<dim>::substitute_backward(const NodeVector &r_vector,
                                               NodeVector &z_vector) const
  {
    const int n    = grid.n_nodes(0);
    double product = 0.;
    for (int line = grid.n_lines() - 1; line >= 0; --line)
      {
        const std::ptrdiff_t first = std::ptrdiff_t(line) * n;
        const double *const r      = r_vector.data() + first;
        const double *const d      = inverse.data() + first;
        const double *const row    = rows->row(0, line);
        double *const z            = z_vector.data() + first;
        double *const c            = chain.data();
        const double *above[dim];
        std::ptrdiff_t step[dim];
        for (int a = 1; a < dim; ++a)
          {
            above[a] = rows->row(a, line + rows->line_stride(a));
            step[a]  = 2 * grid.stride(a);
          }
#pragma omp simd
        for (int i = 0; i < n; ++i)
          {
            double sum = 0.;
            for (int a = 1; a < dim; ++a)
              sum += above[a][i] * z[i + step[a]];
            z[i] += d[i] * sum;
            c[i] = d[i] * row[i + 1];
          }
        follow_chain(n, c + n - 1, z + n - 1, -1);
        double sum = 0.;
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < n; ++i)
          sum += r[i] * z[i];
        product += sum;
      }
    return product;
  }

  template <int dim>
  double
  IncompleteCholesky<dim>::apply(const NodeVector &r, NodeVector &z) const
  {
    substitute_forward(r, z);
    return substitute_backward(r, z);
  }

  template class IncompleteCholesky<2>;
  template class IncompleteCholesky<3>;
} // namespace magmpm::paper_scheme
