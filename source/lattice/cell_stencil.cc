#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/cell_stencil.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr double gauss_distance = 0.774596669241483377; // sqrt(3/5)

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
    template <int dim, typename Matrix>
    void
    add_transposed(const PointValues<dim> &values, const Matrix &matrix, StencilValues<dim> &result)
    {
      StencilValues<dim> sum;
      contract<dim, n_points_1d, stencil_edge>(matrix, values.data(), sum.data());
      for (int i = 0; i < n_stencil_nodes<dim> * n_lanes; ++i)
        result[i] += sum[i];
    }
  } // namespace

  template <int dim>
  const std::array<double, n_points_1d> CellStencil<dim>::points_1d = {
    {1. - gauss_distance, 1., 1. + gauss_distance}};

  template <int dim>
  const std::array<double, n_points_1d> CellStencil<dim>::weights_1d = {
    {5. / 9., 8. / 9., 5. / 9.}};

  template <int dim>
  CellStencil<dim>::CellStencil(const int cell_edge)
    : value_matrix{}
    , derivative_matrix{}
  {
    for (int q = 0; q < n_points_1d; ++q)
      {
        const double point = 0.5 * cell_edge * points_1d[q];
        const int base     = static_cast<int>(std::floor(point - 0.5));
        double weights[stencil_width], derivatives[stencil_width];
        quadratic_bspline(point - base, weights);
        quadratic_bspline_derivative(point - base, derivatives);
        for (int i = 0; i < stencil_width; ++i)
          {
            value_matrix[q][base + 1 + i]      = weights[i];
            derivative_matrix[q][base + 1 + i] = derivatives[i];
          }
      }
  }

  template <int dim>
  template <typename Function>
  void
  CellStencil<dim>::for_each_node(const BlockSet<dim> &blocks,
                                  const int slot,
                                  const Index<dim> &corner,
                                  const Function &f)
  {
    // Nodes -1 .. 3 from the corner, which is one of 0 .. 3.
    using Window                = NodeWindow<dim, 1, 3>;
    static constexpr auto boxes = Window::template box_offsets<stencil_edge>();
    const auto &neighbours      = blocks.neighbours(slot);
    int first                   = 0;
    for (int d = 0; d < dim; ++d)
      first += Window::stride(d) * corner[d];
    for (int i = 0; i < n_stencil_nodes<dim>; ++i)
      {
        const NodePlace &place = Window::place(first + boxes[i]);
        f(i, neighbours[place.neighbour], place.node);
      }
  }

  template <int dim>
  void
  CellStencil<dim>::gather(const NodeNumbers<dim> &field,
                           const BlockSet<dim> &blocks,
                           const int slot,
                           const Index<dim> &corner,
                           StencilValues<dim> &values) const
  {
    const int width = std::min(field.layout().n_lanes, n_lanes);
    values.fill(0.);
    for_each_node(blocks, slot, corner, [&](const int i, const int other, const int node) {
      if (other != invalid_slot)
        std::copy_n(field.node(other, node), width, &values[i * n_lanes]);
    });
  }

  template <int dim>
  void
  CellStencil<dim>::scatter_add(const StencilValues<dim> &values,
                                const BlockSet<dim> &blocks,
                                const int slot,
                                const Index<dim> &corner,
                                NodeNumbers<dim> &field) const
  {
    const int width = std::min(field.layout().n_lanes, n_lanes);
    for_each_node(blocks, slot, corner, [&](const int i, const int other, const int node) {
      if (other == invalid_slot)
        return;
      double *lanes = field.node(other, node);
      for (int lane = 0; lane < width; ++lane)
        lanes[lane] += values[i * n_lanes + lane];
    });
  }

  template <int dim>
  void
  CellStencil<dim>::interpolate(const StencilValues<dim> &values, PointValues<dim> &result) const
  {
    contract<dim, stencil_edge, n_points_1d>(
      [this](const int, const int point, const int node) { return value_matrix[point][node]; },
      values.data(),
      result.data());
  }

  template <int dim>
  void
  CellStencil<dim>::interpolate_derivative(const StencilValues<dim> &values,
                                           const int derivative_axis,
                                           PointValues<dim> &result) const
  {
    contract<dim, stencil_edge, n_points_1d>(
      [this, derivative_axis](const int axis, const int point, const int node) {
        return axis == derivative_axis ? derivative_matrix[point][node] : value_matrix[point][node];
      },
      values.data(),
      result.data());
  }

  template <int dim>
  void
  CellStencil<dim>::add_tested(const PointValues<dim> &values, StencilValues<dim> &result) const
  {
    add_transposed<dim>(
      values,
      [this](const int, const int node, const int point) { return value_matrix[point][node]; },
      result);
  }

  template <int dim>
  void
  CellStencil<dim>::add_tested_by_derivative(const PointValues<dim> &values,
                                             const int derivative_axis,
                                             StencilValues<dim> &result) const
  {
    add_transposed<dim>(
      values,
      [this, derivative_axis](const int axis, const int node, const int point) {
        return axis == derivative_axis ? derivative_matrix[point][node] : value_matrix[point][node];
      },
      result);
  }

  template class CellStencil<2>;
  template class CellStencil<3>;
} // namespace magmpm
