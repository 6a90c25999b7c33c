#include <magmpm/lattice/bspline.h>
#include <magmpm/magnetics/cell_stencil.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr double gauss_distance = 0.774596669241483377; // sqrt(3/5)

    /**
     * out(.., o, ..) = sum_i matrix(o, i) in(.., i, ..) along one axis.
     *
     * @param n_inner  values that lie between neighbours on the axis (lanes and faster axes).
     * @param n_outer  repetitions (slower axes).
     */
    template <int n_in, int n_out, typename Matrix1D>
    void
    contract(const Matrix1D &matrix,
             const double *in,
             const int n_inner,
             const int n_outer,
             double *out)
    {
      for (int outer = 0; outer < n_outer; ++outer, in += n_in * n_inner, out += n_out * n_inner)
        for (int o = 0; o < n_out; ++o)
          {
            std::fill_n(out + o * n_inner, n_inner, 0.);
            for (int i = 0; i < n_in; ++i)
              {
                const double factor = matrix(o, i);
                if (factor != 0.)
                  for (int k = 0; k < n_inner; ++k)
                    out[o * n_inner + k] += factor * in[i * n_inner + k];
              }
          }
    }

    /** Values at points from those of nodes; @p matrix(axis, point, node). */
    template <int dim, typename Matrix>
    void
    contract_nodes(const StencilValues<dim> &values, const Matrix &matrix, PointValues<dim> &result)
    {
      StencilValues<dim> buffer[2];
      const double *in = values.data();
      int n_inner      = n_lanes;
      for (int axis = 0; axis < dim; ++axis)
        {
          double *out       = (axis == dim - 1 ? result.data() : buffer[axis % 2].data());
          const int n_outer = power(stencil_edge, dim - 1 - axis);
          contract<stencil_edge, n_points_1d>(
            [&](const int point, const int node) { return matrix(axis, point, node); },
            in,
            n_inner,
            n_outer,
            out);
          in = out;
          n_inner *= n_points_1d;
        }
    }

    /** Adds the values of points to nodes; @p matrix(axis, point, node). */
    template <int dim, typename Matrix>
    void
    add_transposed(const PointValues<dim> &values, const Matrix &matrix, StencilValues<dim> &result)
    {
      // Sizes shrink and grow axis by axis; the largest intermediate array is that of the nodes.
      StencilValues<dim> buffer[2];
      const double *in = values.data();
      int n_inner      = n_lanes;
      for (int axis = 0; axis < dim; ++axis)
        {
          double *out       = buffer[axis % 2].data();
          const int n_outer = power(n_points_1d, dim - 1 - axis);
          contract<n_points_1d, stencil_edge>(
            [&](const int node, const int point) { return matrix(axis, point, node); },
            in,
            n_inner,
            n_outer,
            out);
          in = out;
          n_inner *= stencil_edge;
        }
      for (int i = 0; i < n_stencil_nodes<dim> * n_lanes; ++i)
        result[i] += in[i];
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

    for (int corner = 0; corner < nodes_per_block<dim>; ++corner)
      for (int i = 0; i < n_stencil_nodes<dim>; ++i)
        {
          Place place = {0, 0};
          for (int d = 0, rest = i, lower = corner; d < dim; ++d)
            {
              const int node = lower % block_edge - 1 + rest % stencil_edge; // -1 .. 6
              rest /= stencil_edge;
              lower /= block_edge;
              place.neighbour += power(3, d) * (node < 0 ? 0 : (node < block_edge ? 1 : 2));
              place.node += power(block_edge, d) * ((node + block_edge) % block_edge);
            }
          places[corner][i] = place;
        }
  }

  template <int dim>
  int
  CellStencil<dim>::number_in_block(const Index<dim> &corner)
  {
    int number = 0;
    for (int d = 0; d < dim; ++d)
      number += power(block_edge, d) * corner[d];
    return number;
  }

  template <int dim>
  void
  CellStencil<dim>::gather(const NodeField<dim> &field,
                           const BlockSet<dim> &blocks,
                           const int slot,
                           const Index<dim> &corner,
                           StencilValues<dim> &values) const
  {
    const auto &neighbours = blocks.neighbours(slot);
    const Places &nodes    = places[number_in_block(corner)];
    for (int i = 0; i < n_stencil_nodes<dim>; ++i)
      {
        const int other = neighbours[nodes[i].neighbour];
        if (other == invalid_slot)
          std::fill_n(&values[i * n_lanes], n_lanes, 0.);
        else
          std::copy_n(field.node(other, nodes[i].node), n_lanes, &values[i * n_lanes]);
      }
  }

  template <int dim>
  void
  CellStencil<dim>::scatter_add(const StencilValues<dim> &values,
                                const BlockSet<dim> &blocks,
                                const int slot,
                                const Index<dim> &corner,
                                NodeField<dim> &field) const
  {
    const auto &neighbours = blocks.neighbours(slot);
    const Places &nodes    = places[number_in_block(corner)];
    for (int i = 0; i < n_stencil_nodes<dim>; ++i)
      {
        const int other = neighbours[nodes[i].neighbour];
        if (other == invalid_slot)
          continue;
        double *node = field.node(other, nodes[i].node);
        for (int lane = 0; lane < n_lanes; ++lane)
          node[lane] += values[i * n_lanes + lane];
      }
  }

  template <int dim>
  void
  CellStencil<dim>::interpolate(const StencilValues<dim> &values, PointValues<dim> &result) const
  {
    contract_nodes<dim>(
      values,
      [this](const int, const int point, const int node) { return value_matrix[point][node]; },
      result);
  }

  template <int dim>
  void
  CellStencil<dim>::interpolate_derivative(const StencilValues<dim> &values,
                                           const int derivative_axis,
                                           PointValues<dim> &result) const
  {
    contract_nodes<dim>(
      values,
      [this, derivative_axis](const int axis, const int point, const int node) {
        return axis == derivative_axis ? derivative_matrix[point][node] : value_matrix[point][node];
      },
      result);
  }

  template <int dim>
  void
  CellStencil<dim>::add_tested(const PointValues<dim> &values, StencilValues<dim> &result) const
  {
    add_transposed<dim>(
      values,
      [this](const int, const int point, const int node) { return value_matrix[point][node]; },
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
      [this, derivative_axis](const int axis, const int point, const int node) {
        return axis == derivative_axis ? derivative_matrix[point][node] : value_matrix[point][node];
      },
      result);
  }

  template class CellStencil<2>;
  template class CellStencil<3>;
} // namespace magmpm
