#include "catch.h"

#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/cell_quadrature.h>

#include <vector>

using namespace magmpm;

namespace
{
  /** A function at the nodes -1 .. 3 around a cell, in all lanes. */
  template <int dim, typename Function>
  StencilValues<dim>
  nodal_values(const Function &function)
  {
    StencilValues<dim> values;
    for (int i = 0; i < n_stencil_nodes<dim>; ++i)
      {
        Vector<dim> x;
        for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_edge)
          x[d] = rest % stencil_edge - 1;
        for (int lane = 0; lane < n_lanes; ++lane)
          values[i * n_lanes + lane] = (lane + 1) * function(x);
      }
    return values;
  }
} // namespace

// Interpolation from nodes to the points of a rule reproduces a linear function. Quadratic B-splines
// reproduce linear functions exactly, whatever the coefficients.
TEMPLATE_TEST_CASE_SIG("A cell quadrature interpolates linear functions",
                       "[lattice]",
                       ((int dim, int n), dim, n),
                       (2, 2),
                       (3, 2),
                       (2, 3),
                       (3, 3),
                       (2, 4),
                       (3, 4))
{
  const auto linear = [](const Vector<dim> &x) {
    return 0.7 + 1.3 * x[0] - 2.1 * x[1] + 0.4 * x[dim - 1];
  };
  const CellQuadrature<dim, n> rule(2);
  PointValues<dim, n> values;
  rule.interpolate(nodal_values<dim>(linear), values);
  for (int q = 0; q < rule.size(); ++q)
    for (int lane = 0; lane < n_lanes; ++lane)
      CHECK(values[q * n_lanes + lane] ==
            Approx((lane + 1) * linear(rule.offset(q))).epsilon(1e-13));
}

// The rules integrate what QGauss of their order does: x^3 y^3 on a cell of edge h, h^8/16 in 2D and
// h^9/16 in 3D, and for three points x^5 also. Every octant has as many points of the fine rule as
// it has corners, and their mean is its middle.
TEMPLATE_TEST_CASE_SIG("A cell quadrature integrates, and its octants are in place",
                       "[lattice]",
                       ((int dim, int n), dim, n),
                       (2, 2),
                       (3, 2),
                       (2, 3),
                       (3, 3),
                       (2, 4),
                       (3, 4))
{
  for (const int cell_edge : {1, 2})
    {
      constexpr double spacing = 0.3;
      const double edge        = cell_edge * spacing;
      const CellQuadrature<dim, n> rule(cell_edge, spacing);
      double cubic = 0., fifth = 0.;
      std::array<Vector<dim>, n_octants<dim>> middles = {};
      for (int q = 0; q < rule.size(); ++q)
        {
          const Vector<dim> &x = rule.offset(q);
          cubic += rule.weight(q) * std::pow(x[0] * x[1], 3);
          fifth += rule.weight(q) * std::pow(x[0], 5);
          middles[n == 4 ? octant_of_point<dim>(q) : 0] += (1. / n_octants<dim>)*x;
        }
      CHECK(cubic == Approx(std::pow(edge, 6 + dim) / 16.).epsilon(1e-13));
      if (n == 3)
        CHECK(fifth == Approx(std::pow(edge, 5 + dim) / 6.).epsilon(1e-13));
      for (int octant = 0; n == 4 && octant < n_octants<dim>; ++octant)
        for (int d = 0; d < dim; ++d)
          CHECK(middles[octant][d] == Approx(edge * (0.25 + 0.5 * (octant >> d & 1))));
    }
}

// What is tested by N_i is the transpose of interpolation, and what is tested by dN_i/dx is its
// derivative: for nodal values u_i of a linear function, sum_i u_i (tested by dN_i/dx)_i is slope times
// the tested value, and for constant u it is zero.
TEMPLATE_TEST_CASE_SIG("A cell quadrature tests with values and derivatives",
                       "[lattice]",
                       ((int dim, int n), dim, n),
                       (2, 2),
                       (3, 2),
                       (2, 3),
                       (3, 3),
                       (2, 4),
                       (3, 4))
{
  const CellQuadrature<dim, n> rule(2);
  PointValues<dim, n> tested;
  double sum = 0.;
  for (int i = 0; i < rule.size() * n_lanes; ++i)
    {
      tested[i] = std::sin(1. + i);
      sum += (i % n_lanes == 0 ? tested[i] : 0.);
    }
  const auto product = [](const StencilValues<dim> &a, const StencilValues<dim> &b) {
    double result = 0.;
    for (int i = 0; i < n_stencil_nodes<dim>; ++i)
      result += a[i * n_lanes] * b[i * n_lanes];
    return result;
  };

  const StencilValues<dim> u =
    nodal_values<dim>([](const Vector<dim> &x) { return std::cos(3. * x[0]) + x[dim - 1] * x[0]; });
  PointValues<dim, n> u_at_points;
  rule.interpolate(u, u_at_points);
  double expected = 0.;
  for (int q = 0; q < rule.size(); ++q)
    expected += u_at_points[q * n_lanes] * tested[q * n_lanes];
  StencilValues<dim> by_value = {};
  rule.add_tested(tested, by_value);
  CHECK(product(u, by_value) == Approx(expected).epsilon(1e-13));

  for (int axis = 0; axis < dim; ++axis)
    {
      StencilValues<dim> by_derivative = {};
      rule.add_tested_by_derivative(tested, axis, by_derivative);
      for (int direction = 0; direction < dim; ++direction)
        {
          const auto coordinate =
            nodal_values<dim>([direction](const Vector<dim> &x) { return x[direction]; });
          CHECK(product(coordinate, by_derivative) ==
                Approx(direction == axis ? sum : 0.).margin(1e-12));
        }
      const auto one = nodal_values<dim>([](const Vector<dim> &) { return 1.; });
      CHECK(product(one, by_derivative) == Approx(0.).margin(1e-12));
    }
}

// A stencil reads the nodes of the blocks around its cell at their right places, and adds to the same
// ones. The field holds the position of each node, so that every value says where it comes from.
TEMPLATE_TEST_CASE_SIG("A cell stencil gathers from the blocks around",
                       "[lattice]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The block at the origin, and all around but the last.
  std::vector<Index<dim>> blocks;
  Index<dim> origin = {};
  for (int n = 0; n < n_neighbours<dim> - 1; ++n)
    blocks.push_back(neighbour_block<dim>(origin, n));
  const BlockSet<dim> set(blocks, static_cast<int>(blocks.size()));
  NodeField<dim> field, ones;
  field.reinit(set.size());
  ones.reinit(set.size());
  for (int slot = 0; slot < set.size(); ++slot)
    for (int node = 0; node < nodes_per_block<dim>; ++node)
      for (int d = 0; d < dim; ++d)
        field.node(slot, node)[d] = node_of_block<dim>(set.block(slot), node)[d];

  Index<dim> corner;
  corner.fill(2);
  corner[0] = 0;
  StencilValues<dim> values;
  gather_stencil<dim>(field, set, set.slot(origin), corner, values);
  for (int i = 0; i < n_stencil_nodes<dim>; ++i)
    for (int d = 0, rest = i; d < dim; ++d, rest /= stencil_edge)
      CHECK(values[i * n_lanes + d] == corner[d] - 1 + rest % stencil_edge);

  // From corner (2, 2, ..) the stencil reaches into the missing block: zero there.
  corner.fill(2);
  gather_stencil<dim>(field, set, set.slot(origin), corner, values);
  CHECK(values[(n_stencil_nodes<dim> - 1) * n_lanes] == 0.);

  StencilValues<dim> one;
  one.fill(1.);
  scatter_stencil<dim>(one, set, set.slot(origin), corner, ones);
  double sum = 0.;
  for (int slot = 0; slot < set.size(); ++slot)
    for (int node = 0; node < nodes_per_block<dim>; ++node)
      sum += ones.node(slot, node)[0];
  CHECK(sum == n_stencil_nodes<dim> - power(2, dim)); // nodes 4 and 5 of every axis are missing
}
