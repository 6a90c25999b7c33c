#include <paper_scheme/incomplete_cholesky.h>

namespace magmpm::paper_scheme
{
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

    const int n = grid.n_nodes(0);
    for (int line = 0; line < grid.n_lines(); ++line)
      for (int i = 0; i < n; ++i)
        {
          const std::ptrdiff_t node = std::ptrdiff_t(line) * n + i;
          inverse[node]             = 1. / pivot(line, i, diagonal[node], modification);
        }
  }

  template <int dim>
  double
  IncompleteCholesky<dim>::pivot(const std::ptrdiff_t line,
                                 const int x,
                                 const double diagonal,
                                 const double modification) const
  {
    constexpr double smallest = 0.25;
    const std::ptrdiff_t node = line * grid.n_nodes(0) + x;
    double result             = diagonal;
    for (int a = 0; a < dim; ++a)
      {
        // The neighbour 2 dx below along a; its entries above, along the other axes, are the fill.
        const std::ptrdiff_t step = (a == 0 ? 0 : rows->line_stride(a));
        const double w            = rows->row(a, line - step)[x - (a == 0)];
        if (w == 0.)
          continue;
        const int below_x               = x - (a == 0 ? 2 : 0);
        const std::ptrdiff_t below_line = line - 2 * step;
        double fill                     = 0.;
        for (int b = 0; b < dim; ++b)
          if (b != a)
            fill += b == 0 ? rows->row(0, below_line)[below_x + 1]
                           : rows->row(b, below_line + rows->line_stride(b))[below_x];
        result -= w * (w + modification * fill) * inverse[node - 2 * grid.stride(a)];
      }
    return result < smallest * diagonal ? diagonal : result;
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
        for (int i = 0; i < n; ++i)
          {
            double sum = r[i];
            for (int a = 1; a < dim; ++a)
              sum += below[a][i] * z[i - step[a]];
            z[i] = d[i] * sum;
            c[i] = d[i] * row[i - 1];
          }
        for (int i = 2; i < n; ++i)
          z[i] += c[i] * z[i - 2];
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
        for (int i = 0; i < n; ++i)
          {
            double sum = 0.;
            for (int a = 1; a < dim; ++a)
              sum += above[a][i] * z[i + step[a]];
            z[i] += d[i] * sum;
            c[i] = d[i] * row[i + 1];
          }
        for (int i = n - 3; i >= 0; --i)
          z[i] += c[i] * z[i + 2];
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
