#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/cell_quadrature.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /**
     * out(.., o, ..) = sum_i matrix(axis, o, i) in(.., i, ..) along @p axis and, from there, all slower
     * ones: n_in values become n_out. Sizes are known to the compiler, which makes straight code of it.
     */
    template <int dim, int n_in, int n_out, int axis = 0, typename Matrix>
    void
    contract(const Matrix &matrix, const double *__restrict in, double *__restrict out)
    {
      // Lanes and faster axes lie between neighbours on the axis; slower axes are repetitions.
      constexpr int n_inner = n_lanes * power(n_out, axis);
      constexpr int n_outer = power(n_in, dim - 1 - axis);
      double buffer[axis == dim - 1 ? 1 : n_inner * n_out * n_outer];
      double *__restrict rows = (axis == dim - 1 ? out : buffer);
      for (int outer = 0; outer < n_outer; ++outer)
        for (int o = 0; o < n_out; ++o)
          {
            double *__restrict row = rows + (outer * n_out + o) * n_inner;
            std::fill_n(row, n_inner, 0.);
            for (int i = 0; i < n_in; ++i)
              {
                const double factor = matrix(axis, o, i);
                const double *term  = in + (outer * n_in + i) * n_inner;
                if (factor != 0.)
                  for (int k = 0; k < n_inner; ++k)
                    row[k] += factor * term[k];
              }
          }
      if constexpr (axis < dim - 1)
        contract<dim, n_in, n_out, axis + 1>(matrix, buffer, out);
    }

    /** Adds the values of points to nodes; @p matrix(axis, node, point). */
    template <int dim, int n, typename Matrix>
    void
    add_transposed(const PointValues<dim, n> &values,
                   const Matrix &matrix,
                   StencilValues<dim> &result)
    {
      StencilValues<dim> sum;
      contract<dim, n, stencil_edge>(matrix, values.data(), sum.data());
      for (int i = 0; i < n_stencil_nodes<dim> * n_lanes; ++i)
        result[i] += sum[i];
    }
  } // namespace

  template <int dim, int n>
  CellQuadrature<dim, n>::CellQuadrature(const int cell_edge, const double spacing)
    : value_matrix{}
    , derivative_matrix{}
  {
    const double half_edge = 0.5 * cell_edge;
    for (int q = 0; q < size(); ++q)
      {
        weights[q] = 1.;
        for (int d = 0, rest = q; d < dim; ++d, rest /= n)
          {
            weights[q] *= half_edge * spacing * CellRule<n>::weights[rest % n];
            offsets[q][d] = half_edge * spacing * CellRule<n>::points[rest % n];
          }
      }
    for (int q = 0; q < n; ++q)
      {
        const double point = half_edge * CellRule<n>::points[q];
        const int base     = static_cast<int>(std::floor(point - 0.5));
        double values[stencil_width], derivatives[stencil_width];
        quadratic_bspline(point - base, values);
        quadratic_bspline_derivative(point - base, derivatives);
        for (int i = 0; i < stencil_width; ++i)
          {
            value_matrix[q][base + 1 + i]      = values[i];
            derivative_matrix[q][base + 1 + i] = derivatives[i];
          }
      }
  }

  template <int dim, int n>
  void
  CellQuadrature<dim, n>::interpolate(const StencilValues<dim> &values, Values &result) const
  {
    contract<dim, stencil_edge, n>(
      [this](const int, const int point, const int node) { return value_matrix[point][node]; },
      values.data(),
      result.data());
  }

  template <int dim, int n>
  void
  CellQuadrature<dim, n>::interpolate_derivative(const StencilValues<dim> &values,
                                                 const int derivative_axis,
                                                 Values &result) const
  {
    contract<dim, stencil_edge, n>(
      [this, derivative_axis](const int axis, const int point, const int node) {
        return axis == derivative_axis ? derivative_matrix[point][node] : value_matrix[point][node];
      },
      values.data(),
      result.data());
  }

  template <int dim, int n>
  void
  CellQuadrature<dim, n>::add_tested(const Values &values, StencilValues<dim> &result) const
  {
    add_transposed<dim, n>(
      values,
      [this](const int, const int node, const int point) { return value_matrix[point][node]; },
      result);
  }

  template <int dim, int n>
  void
  CellQuadrature<dim, n>::add_tested_by_derivative(const Values &values,
                                                   const int derivative_axis,
                                                   StencilValues<dim> &result) const
  {
    add_transposed<dim, n>(
      values,
      [this, derivative_axis](const int axis, const int node, const int point) {
        return axis == derivative_axis ? derivative_matrix[point][node] : value_matrix[point][node];
      },
      result);
  }

#define INSTANTIATE(dim)                 \
  template class CellQuadrature<dim, 2>; \
  template class CellQuadrature<dim, 3>; \
  template class CellQuadrature<dim, 4>;

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
