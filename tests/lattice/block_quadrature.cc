#include "catch.h"

#include <magmpm/lattice/block_quadrature.h>

#include <cmath>
#include <random>

using namespace magmpm;

namespace
{
  template <int dim>
  using NodeValues = typename BlockQuadrature<dim>::NodeValues;

  /** The node of a place in the window, from the lower corner of the block. */
  template <int dim>
  Vector<dim>
  node_at(const int place)
  {
    constexpr int edge = BlockQuadrature<dim>::Window::edge;
    Vector<dim> x;
    for (int d = 0, rest = place; d < dim; ++d, rest /= edge)
      x[d] = rest % edge - 1;
    return x;
  }

  template <int dim>
  Vector<dim>
  point_of(const BlockQuadrature<dim> &rule, const int plane, const int q)
  {
    Vector<dim> x;
    x[0] = rule.coordinates()[q % rule.points_1d];
    x[1] = rule.coordinates()[q / rule.points_1d];
    if (dim == 3)
      x[dim - 1] = rule.coordinates()[plane];
    return x;
  }

  template <int dim>
  NodeValues<dim>
  random_values(const unsigned int seed)
  {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> number(-1., 1.);
    NodeValues<dim> values;
    for (double &value : values)
      value = number(generator);
    return values;
  }
} // namespace

// Interpolation to the points of a block reproduces a linear function and its gradient: quadratic B-splines do,
// whatever the coefficients.
TEMPLATE_TEST_CASE_SIG("A block quadrature interpolates linear functions",
                       "[lattice]",
                       ((int dim), dim),
                       2,
                       3)
{
  const BlockQuadrature<dim> rule;
  Vector<dim> slope;
  for (int d = 0; d < dim; ++d)
    slope[d] = 1.3 - 0.9 * d;
  NodeValues<dim> nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    nodes[i] = 0.7 + dot(slope, node_at<dim>(static_cast<int>(i)));

  typename BlockQuadrature<dim>::PlaneValues values, alone;
  typename BlockQuadrature<dim>::PlaneGradients gradients;
  for (int plane = 0; plane < rule.n_planes; ++plane)
    {
      rule.interpolate(nodes, plane, values, gradients);
      rule.interpolate(nodes, plane, alone);
      for (int q = 0; q < rule.plane; ++q)
        {
          CHECK(std::abs(values[q] - 0.7 - dot(slope, point_of<dim>(rule, plane, q))) < 1e-13);
          CHECK(alone[q] == values[q]);
          for (int d = 0; d < dim; ++d)
            CHECK(std::abs(gradients[d][q] - slope[d]) < 1e-13);
        }
    }
}

// Testing by gradients is the transpose of finding them: sum_q F_q . (grad v)_q = sum_i v_i (tested F)_i
// for any F and v, which binds all entries of both.
TEMPLATE_TEST_CASE_SIG("A block quadrature tests by the gradients that it finds",
                       "[lattice]",
                       ((int dim), dim),
                       2,
                       3)
{
  const BlockQuadrature<dim> rule;
  const NodeValues<dim> nodes = random_values<dim>(1);
  typename BlockQuadrature<dim>::PlaneValues values;
  typename BlockQuadrature<dim>::PlaneGradients gradients, fluxes;
  NodeValues<dim> tested = {};
  double by_points       = 0.;
  for (int plane = 0; plane < rule.n_planes; ++plane)
    {
      rule.interpolate(nodes, plane, values, gradients);
      for (int d = 0; d < dim; ++d)
        for (int q = 0; q < rule.plane; ++q)
          {
            fluxes[d][q] = std::sin(1.7 * q + 3. * d + 0.4 * plane);
            by_points += fluxes[d][q] * gradients[d][q];
          }
      rule.add_tested_by_gradient(fluxes, plane, tested);
    }
  double by_nodes = 0.;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    by_nodes += nodes[i] * tested[i];
  CHECK(by_nodes == Approx(by_points).epsilon(1e-12));
}

// The weights are those of QGauss(3) in each of four cells: x^5 over (0, 4) is 4^6/6 by them.
TEST_CASE("A block quadrature integrates x^5", "[lattice]")
{
  const BlockQuadrature<3> rule;
  double integral = 0.;
  for (int q = 0; q < rule.points_1d; ++q)
    integral += rule.weights_1d()[q] * std::pow(rule.coordinates()[q], 5);
  CHECK(integral == Approx(std::pow(4., 6) / 6.).epsilon(1e-13));
}
