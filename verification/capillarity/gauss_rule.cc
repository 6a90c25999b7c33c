#include <magmpm/base/constants.h>

#include <verification/capillarity/gauss_rule.h>

#include <cmath>

namespace magmpm::verification
{
  Legendre
  legendre(const int n, const double x)
  {
    // (i + 1) P_(i+1) = (2 i + 1) x P_i - i P_(i-1), and its derivative.
    Legendre before = {0., 0.}, now = {1., 0.};
    for (int i = 0; i < n; ++i)
      {
        const Legendre next = {((2. * i + 1.) * x * now.value - i * before.value) / (i + 1.),
                               ((2. * i + 1.) * (now.value + x * now.slope) - i * before.slope) /
                                 (i + 1.)};
        before              = now;
        now                 = next;
      }
    return now;
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
            const Legendre p       = legendre(n - 1, x);
            const double curvature = (2. * x * p.slope - n * (n - 1.) * p.value) / (1. - x * x);
            x -= p.slope / curvature;
          }
        points.push_back(0.5 * (1. + x));
      }
    points.push_back(1.);
    return points;
  }
} // namespace magmpm::verification
