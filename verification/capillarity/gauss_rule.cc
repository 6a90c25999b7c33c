#include <magmpm/base/constants.h>

#include <verification/capillarity/gauss_rule.h>

#include <cmath>
#include <cstddef>

namespace magmpm::verification
{
  ValueAndSlope
  legendre(const int n, const double x)
  {
    // (i + 1) P_(i+1) = (2 i + 1) x P_i - i P_(i-1), and its derivative.
    ValueAndSlope before = {0., 0.}, now = {1., 0.};
    for (int i = 0; i < n; ++i)
      {
        const ValueAndSlope next = {
          ((2. * i + 1.) * x * now.value - i * before.value) / (i + 1.),
          ((2. * i + 1.) * (now.value + x * now.slope) - i * before.slope) / (i + 1.)};
        before = now;
        now    = next;
      }
    return now;
  }

  ValueAndSlope
  lagrange(const std::vector<double> &places, const int i, const double x)
  {
    ValueAndSlope result = {1., 0.};
    for (std::size_t j = 0; j < places.size(); ++j)
      if (static_cast<int>(j) != i)
        {
          const double part = 1. / (places[i] - places[j]);
          result.slope      = result.slope * (x - places[j]) * part + result.value * part;
          result.value *= (x - places[j]) * part;
        }
    return result;
  }

  GaussRule
  gauss_rule(const int n)
  {
    GaussRule rule;
    for (int i = 0; i < n; ++i)
      {
        double x = -std::cos(constants::pi * (i + 0.75) / (n + 0.5));
        for (int step = 0; step < 20; ++step)
          x -= legendre(n, x).value / legendre(n, x).slope;
        const double slope = legendre(n, x).slope;
        rule.points.push_back(0.5 * (1. + x));
        rule.weights.push_back(1. / ((1. - x * x) * slope * slope));
      }
    return rule;
  }

  std::vector<double>
  lobatto_points(const int n)
  {
    std::vector<double> points = {0.};
    for (int i = 1; i + 1 < n; ++i)
      {
        // A zero of P'_(n-1), between those of P_(n-1); (1 - x^2) P'' = 2 x P' - n (n - 1) P.
        double x = -std::cos(constants::pi * i / (n - 1.));
        for (int step = 0; step < 50; ++step)
          {
            const ValueAndSlope p  = legendre(n - 1, x);
            const double curvature = (2. * x * p.slope - n * (n - 1.) * p.value) / (1. - x * x);
            x -= p.slope / curvature;
          }
        points.push_back(0.5 * (1. + x));
      }
    points.push_back(1.);
    return points;
  }
} // namespace magmpm::verification
