// Kernels: all lengths are known to the compiler, which makes SIMD code of the inner loops.

#include <magmpm/lattice/block_quadrature.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/cell_quadrature.h>

#include <algorithm>
#include <cmath>

namespace magmpm
{
  template <int dim>
  BlockQuadrature<dim>::BlockQuadrature()
    : value_matrix{}
    , derivative_matrix{}
    , value_rows{}
    , derivative_rows{}
  {
    for (int q = 0; q < points_1d; ++q)
      {
        const int cell = q / 3;
        points[q]      = cell + 0.5 * CellRule<3>::points[q % 3];
        weights[q]     = 0.5 * CellRule<3>::weights[q % 3];
        const int base = static_cast<int>(std::floor(points[q] - 0.5));
        bases[q]       = base + 1; // the window begins one node below
        quadratic_bspline(points[q] - base, value[q]);
        quadratic_bspline_derivative(points[q] - base, derivative[q]);
        for (int i = 0; i < stencil_width; ++i)
          {
            value_matrix[bases[q] + i][q]      = value[q][i];
            derivative_matrix[bases[q] + i][q] = derivative[q][i];
            value_rows[q][bases[q] + i]        = value[q][i];
            derivative_rows[q][bases[q] + i]   = derivative[q][i];
          }
      }
  }

  template <int dim>
  template <bool by_derivative>
  void
  BlockQuadrature<dim>::across(const NodeValues &nodes, const int number, PlaneNodes &result) const
  {
    const double *factors = (by_derivative ? derivative : value)[number];
    const double *below   = nodes.data() + (dim == 3 ? bases[number] * edge * edge : 0);
    for (int y = 0; y < edge; ++y)
      for (int x = 0; x < edge; ++x)
        {
          const double *column = below + y * edge + x;
          if constexpr (dim == 3)
            result[y * row + x] = factors[0] * column[0] + factors[1] * column[edge * edge] +
                                  factors[2] * column[2 * edge * edge];
          else
            result[y * row + x] = column[0];
        }
  }

  namespace
  {
    /** sum_i factors_i of three rows, one below the other. */
    template <int n, int stride>
    inline void
    add_rows(const double (&factors)[3], const double *__restrict rows, double *__restrict sum)
    {
      for (int x = 0; x < n; ++x)
        sum[x] = factors[0] * rows[x] + factors[1] * rows[stride + x] +
                 factors[2] * rows[2 * stride + x];
    }

    /** sum_i matrix[i] row_i. */
    template <int n_rows, int n>
    inline void
    multiply(const double (&matrix)[n_rows][n],
             const double *__restrict factors,
             double *__restrict result)
    {
      double sums[n] = {};
      for (int i = 0; i < n_rows; ++i)
        for (int q = 0; q < n; ++q)
          sums[q] += matrix[i][q] * factors[i];
      std::copy_n(sums, n, result);
    }
  } // namespace

  template <int dim>
  void
  BlockQuadrature<dim>::interpolate(const NodeValues &nodes,
                                    const int number,
                                    PlaneValues &values) const
  {
    PlaneNodes in_plane;
    across<false>(nodes, number, in_plane);
    double sums[row] = {};
    for (int y = 0; y < points_1d; ++y)
      {
        add_rows<edge, row>(value[y], &in_plane[bases[y] * row], sums);
        multiply(value_matrix, sums, &values[y * points_1d]);
      }
  }

  template <int dim>
  void
  BlockQuadrature<dim>::interpolate(const NodeValues &nodes,
                                    const int number,
                                    PlaneValues &values,
                                    PlaneGradients &gradients) const
  {
    PlaneNodes in_plane, slope = {};
    across<false>(nodes, number, in_plane);
    if constexpr (dim == 3)
      across<true>(nodes, number, slope);
    double sums[row] = {};
    for (int y = 0; y < points_1d; ++y)
      {
        add_rows<edge, row>(value[y], &in_plane[bases[y] * row], sums);
        multiply(value_matrix, sums, &values[y * points_1d]);
        multiply(derivative_matrix, sums, &gradients[0][y * points_1d]);
        add_rows<edge, row>(derivative[y], &in_plane[bases[y] * row], sums);
        multiply(value_matrix, sums, &gradients[1][y * points_1d]);
        if constexpr (dim == 3)
          {
            add_rows<edge, row>(value[y], &slope[bases[y] * row], sums);
            multiply(value_matrix, sums, &gradients[2][y * points_1d]);
          }
      }
  }

  template <int dim>
  void
  BlockQuadrature<dim>::add_tested_by_gradient(const PlaneGradients &fluxes,
                                               const int number,
                                               NodeValues &nodes) const
  {
    PlaneNodes in_plane = {}, slope = {};
    for (int y = 0; y < points_1d; ++y)
      {
        double along_x[row], along_y[row], along_z[row];
        multiply(derivative_rows, &fluxes[0][y * points_1d], along_x);
        multiply(value_rows, &fluxes[1][y * points_1d], along_y);
        if constexpr (dim == 3)
          multiply(value_rows, &fluxes[2][y * points_1d], along_z);
        for (int i = 0; i < stencil_width; ++i)
          for (int x = 0; x < row; ++x)
            {
              const int node = (bases[y] + i) * row + x;
              in_plane[node] += value[y][i] * along_x[x] + derivative[y][i] * along_y[x];
              if constexpr (dim == 3)
                slope[node] += value[y][i] * along_z[x];
            }
      }
    if constexpr (dim == 2)
      for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
          nodes[y * edge + x] += in_plane[y * row + x];
    else
      for (int i = 0; i < stencil_width; ++i)
        for (int y = 0; y < edge; ++y)
          for (int x = 0; x < edge; ++x)
            nodes[((bases[number] + i) * edge + y) * edge + x] +=
              value[number][i] * in_plane[y * row + x] + derivative[number][i] * slope[y * row + x];
  }

  template class BlockQuadrature<2>;
  template class BlockQuadrature<3>;
} // namespace magmpm
