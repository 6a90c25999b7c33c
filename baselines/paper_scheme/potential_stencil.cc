#include <magmpm/base/exceptions.h>

#include <baselines/paper_scheme/potential_stencil.h>

#include <array>
#include <cmath>

namespace magmpm::paper_scheme
{
  template <int dim>
  PotentialStencil<dim>::PotentialStencil(const NodeGrid<dim> &grid)
    : grid(grid)
    , rows(grid)
  {
  }

  template <int dim>
  void
  PotentialStencil<dim>::shield()
  {
    robin.clear();
  }

  template <int dim>
  void
  PotentialStencil<dim>::open(const Vector<dim> &centre)
  {
    robin.clear();
    for (int a = 0; a < dim; ++a)
      for (const int layer : {0, 1})
        {
          open_layer(centre, a, layer, -1);
          open_layer(centre, a, grid.n_cells[a] - layer, +1);
        }
  }

  template <int dim>
  void
  PotentialStencil<dim>::open_layer(const Vector<dim> &centre,
                                    const int axis,
                                    const int layer,
                                    const int side)
  {
    const double area             = 0.5 * std::pow(grid.spacing, dim - 1);
    const std::ptrdiff_t in_layer = grid.size() / grid.n_nodes(axis);
    for (std::ptrdiff_t i = 0; i < in_layer; ++i)
      {
        const std::ptrdiff_t below  = i % grid.stride(axis);
        const std::ptrdiff_t number = below + layer * grid.stride(axis) +
                                      (i - below) * grid.n_nodes(axis);
        Vector<dim> r = grid.node_position(grid.node(number)) - centre;
        r[axis] += side * grid.spacing;
        const double beta = (dim - 1) * side * r[axis] / norm_square(r);
        if (!(beta > 0.))
          throw InputError("The centre of the magnetized material is not within the potential box; "
                           "an open boundary needs a box around it.");
        // From the node to its face, over which phi falls by a factor.
        robin.push_back({number, area * beta / (1. + beta * grid.spacing)});
      }
  }

  template <int dim>
  void
  PotentialStencil<dim>::set_material(const std::vector<MaterialTangent<dim>> &material)
  {
    rows.clear();
    anisotropies.clear();
    for (const MaterialTangent<dim> &point : material)
      {
        Anisotropy anisotropy = {grid.number(point.node), rows.vacuum() * point.tangent};
        double largest        = 0.;
        for (int a = 0; a < dim; ++a)
          {
            rows.scale(a, point.node, 1. + point.tangent(a, a));
            anisotropy.coefficient(a, a) = 0.;
            for (int b = 0; b < a; ++b)
              largest = std::max(largest, std::abs(point.tangent(a, b)));
          }
        if (largest > 0.)
          anisotropies.push_back(anisotropy);
      }
  }

  template <int dim>
  void
  PotentialStencil<dim>::apply_to_line(const std::ptrdiff_t line, const double *x, double *y) const
  {
    const int n       = grid.n_nodes(0);
    const double *row = rows.row(0, line);
#pragma omp simd
    for (int i = 0; i < n; ++i)
      y[i] = row[i - 1] * (x[i] - x[i - 2]) + row[i + 1] * (x[i] - x[i + 2]);
    for (int a = 1; a < dim; ++a)
      {
        const double *below    = rows.row(a, line - rows.line_stride(a));
        const double *above    = rows.row(a, line + rows.line_stride(a));
        const std::ptrdiff_t s = 2 * grid.stride(a);
#pragma omp simd
        for (int i = 0; i < n; ++i)
          y[i] += below[i] * (x[i] - x[i - s]) + above[i] * (x[i] - x[i + s]);
      }
  }

  template <int dim>
  double
  PotentialStencil<dim>::apply(const NodeVector &x_vector, NodeVector &y_vector) const
  {
    const double *const x = x_vector.data();
    double *const y       = y_vector.data();
    const int n           = grid.n_nodes(0);
    double product        = 0.;
    for (int line = 0; line < grid.n_lines(); ++line)
      {
        const double *const x_line = x + std::ptrdiff_t(line) * n;
        double *const y_line       = y + std::ptrdiff_t(line) * n;
        apply_to_line(line, x_line, y_line);
        double sum = 0.;
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < n; ++i)
          sum += x_line[i] * y_line[i];
        product += sum;
      }
    for (const Robin &term : robin)
      {
        const double flux = term.coefficient * x[term.node];
        y[term.node] += flux;
        product += flux * x[term.node];
      }
    for (const Anisotropy &term : anisotropies)
      {
        Vector<dim> difference;
        for (int a = 0; a < dim; ++a)
          difference[a] = x[term.node + grid.stride(a)] - x[term.node - grid.stride(a)];
        const Vector<dim> flux = term.coefficient * difference;
        for (int a = 0; a < dim; ++a)
          {
            y[term.node + grid.stride(a)] += flux[a];
            y[term.node - grid.stride(a)] -= flux[a];
          }
        product += dot(difference, flux);
      }
    return product;
  }

  template <int dim>
  void
  PotentialStencil<dim>::compute_diagonal(NodeVector &diagonal) const
  {
    const int n = grid.n_nodes(0);
    for (int line = 0; line < grid.n_lines(); ++line)
      rows.diagonal(line, diagonal.data() + std::ptrdiff_t(line) * n);
    for (const Robin &term : robin)
      diagonal[term.node] += term.coefficient;
  }

  template <int dim>
  void
  remove_sublattice_means(const NodeGrid<dim> &grid, NodeVector &x)
  {
    constexpr int n_sublattices = 1 << dim;
    std::array<double, n_sublattices> sum, count;
    sum.fill(0.);
    count.fill(0.);
    const int n           = grid.n_nodes(0);
    const auto sublattice = [&](const int line) {
      const Index<dim> node = grid.node(std::ptrdiff_t(line) * n);
      int result            = 0;
      for (int a = 1; a < dim; ++a)
        result += (node[a] % 2) << a;
      return result;
    };
    for (int line = 0; line < grid.n_lines(); ++line)
      for (int i = 0; i < n; ++i)
        {
          sum[sublattice(line) + i % 2] += x[std::ptrdiff_t(line) * n + i];
          count[sublattice(line) + i % 2] += 1.;
        }
    for (int line = 0; line < grid.n_lines(); ++line)
      for (int i = 0; i < n; ++i)
        {
          const int s = sublattice(line) + i % 2;
          x[std::ptrdiff_t(line) * n + i] -= sum[s] / count[s];
        }
  }

  template class PotentialStencil<2>;
  template class PotentialStencil<3>;
  template void
  remove_sublattice_means(const NodeGrid<2> &, NodeVector &);
  template void
  remove_sublattice_means(const NodeGrid<3> &, NodeVector &);
} // namespace magmpm::paper_scheme
