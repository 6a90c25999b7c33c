#include <magmpm/magnets/gauss_points.h>

#include <boost/math/quadrature/gauss.hpp>

namespace magmpm
{
  std::vector<GaussPoint>
  gauss_points()
  {
    // Boost stores the points of [-1, 1] that are not negative, the middle one first.
    using Rule = boost::math::quadrature::gauss<double, 5>;
    std::vector<GaussPoint> points;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
      {
        const double x = Rule::abscissa()[i], half_weight = 0.5 * Rule::weights()[i];
        points.push_back({0.5 + 0.5 * x, half_weight});
        if (x > 0.)
          points.push_back({0.5 - 0.5 * x, half_weight});
      }
    return points;
  }
} // namespace magmpm
