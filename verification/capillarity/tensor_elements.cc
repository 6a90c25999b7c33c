#include <verification/capillarity/band_matrix.h>
#include <verification/capillarity/gauss_rule.h>
#include <verification/capillarity/tensor_elements.h>

#include <cstddef>

namespace magmpm::verification
{
  TensorElements::TensorElements(const std::vector<double> &x,
                                 const std::vector<double> &y,
                                 const int degree,
                                 const FixedSides &fixed)
    : degree(degree)
    , n_points(degree + 2)
    , x_edges(x)
    , y_edges(y)
    , fixed(fixed)
  {
    const GaussRule rule             = gauss_rule(n_points);
    const std::vector<double> places = lobatto_points(degree + 1);
    for (const double point : rule.points)
      for (int i = 0; i <= degree; ++i)
        {
          const ValueAndSlope polynomial = lagrange(places, i, point);
          values.push_back(polynomial.value);
          slopes.push_back(polynomial.slope);
        }
    for (std::size_t ex = 0; ex + 1 < x.size(); ++ex)
      for (int p = 0; p < n_points; ++p)
        for (std::size_t ey = 0; ey + 1 < y.size(); ++ey)
          for (int q = 0; q < n_points; ++q)
            {
              const double width = x[ex + 1] - x[ex], height = y[ey + 1] - y[ey];
              all_points.push_back({x[ex] + width * rule.points[p],
                                    y[ey] + height * rule.points[q],
                                    width * height * rule.weights[p] * rule.weights[q]});
            }
  }

  bool
  TensorElements::is_fixed(const int i, const int j) const
  {
    return (fixed.lower_x && i == 0) || (fixed.upper_x && i == n_nodes(x_edges) - 1) ||
           (fixed.lower_y && j == 0) || (fixed.upper_y && j == n_nodes(y_edges) - 1);
  }

  template <typename Action>
  void
  TensorElements::at_points(const Action &action) const
  {
    const int n = degree + 1, n_y = n_nodes(y_edges);
    std::vector<int> nodes(n * n);
    std::vector<PlaneGradient> gradients(n * n);
    std::size_t point = 0;
    for (std::size_t ex = 0; ex + 1 < x_edges.size(); ++ex)
      for (int p = 0; p < n_points; ++p)
        for (std::size_t ey = 0; ey + 1 < y_edges.size(); ++ey)
          for (int q = 0; q < n_points; ++q)
            {
              for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                  {
                    nodes[i * n + j] = static_cast<int>(ex * degree + i) * n_y +
                                       static_cast<int>(ey * degree + j);
                    gradients[i * n + j] = {
                      slopes[p * n + i] * values[q * n + j] / (x_edges[ex + 1] - x_edges[ex]),
                      values[p * n + i] * slopes[q * n + j] / (y_edges[ey + 1] - y_edges[ey])};
                  }
              action(point++, nodes, gradients);
            }
  }

  std::vector<PlaneGradient>
  TensorElements::solve(const std::vector<QuadraticForm> &forms) const
  {
    const int n_y = n_nodes(y_edges), n = n_nodes(x_edges) * n_y;
    BandMatrix matrix(n, degree * n_y + degree);
    std::vector<double> u(n, 0.);
    at_points([&](const std::size_t point, const auto &nodes, const auto &gradients) {
      const QuadraticForm &form = forms[point];
      const double weight       = all_points[point].weight;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          const double x = weight * (form.a * gradients[i].x + form.b * gradients[i].y);
          const double y = weight * (form.b * gradients[i].x + form.c * gradients[i].y);
          u[nodes[i]] += weight * (form.f * gradients[i].x + form.h * gradients[i].y);
          for (std::size_t j = 0; j < nodes.size(); ++j)
            if (nodes[j] <= nodes[i])
              matrix.add(nodes[i], nodes[j], x * gradients[j].x + y * gradients[j].y);
        }
    });
    for (int i = 0; i < n; ++i)
      if (is_fixed(i / n_y, i % n_y))
        {
          matrix.isolate(i);
          u[i] = 0.;
        }
    matrix.factorize();
    matrix.solve(u);

    std::vector<PlaneGradient> result(all_points.size(), {0., 0.});
    at_points([&](const std::size_t point, const auto &nodes, const auto &gradients) {
      for (std::size_t i = 0; i < nodes.size(); ++i)
        {
          result[point].x += u[nodes[i]] * gradients[i].x;
          result[point].y += u[nodes[i]] * gradients[i].y;
        }
    });
    return result;
  }
} // namespace magmpm::verification
