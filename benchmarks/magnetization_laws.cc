#include <magmpm/base/version.h>
#include <magmpm/magnetics/laminate.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <vector>

using namespace magmpm;

namespace
{
  using Lanes = SimdDouble;

  /** A point of the potential's quadrature, in each lane another field. */
  struct Points
  {
    Vector<3, Lanes> field;
    Lanes fraction;
  };

  std::vector<Points>
  some_points()
  {
    std::vector<Points> points(4096);
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int lane = 0; lane < Lanes::n_lanes; ++lane)
        {
          points[i].field[0].lanes[lane] = 1e3 * (i % 97 + lane);
          points[i].field[1].lanes[lane] = -2e2 * (i % 31);
          points[i].field[2].lanes[lane] = 5e2 * (i % 13 + 1);
          points[i].fraction.lanes[lane] = (i % 3 == 0 ? 0.4 : 1.);
        }
    return points;
  }

  /** The Langevin law of @p content as a table of 40 points. */
  MagnetizationModel
  table(const MagneticContent &content)
  {
    std::vector<double> fields, magnetizations;
    for (int i = 1; i <= 40; ++i)
      {
        fields.push_back(5e3 * i);
        magnetizations.push_back(
          magnetization<2>(MagnetizationLaw::langevin, content, {{fields.back(), 0.}})[0]);
      }
    return {MagnetizationLaw::table,
            std::make_shared<const MagnetizationCurve>(fields, magnetizations)};
  }

  /** The least of many times [s]; @p sum keeps the compiler from leaving the work out. */
  double
  time_of(const MagnetizationModel &model, const std::vector<Points> &points, double &sum)
  {
    const MagneticContentOf<Lanes> content = {8.2e4, 0.91};
    const Vector<3, Lanes> normal          = {{0., 0.6, 0.8}};
    double least                           = 1e300;
    for (int repetition = 0; repetition < 100; ++repetition)
      {
        const auto start = std::chrono::steady_clock::now();
        for (const Points &p : points)
          {
            const auto response = laminate_response(model, content, p.fraction, normal, p.field);
            sum += response.mean.magnetization[0][0] + response.mean.coenergy[0] +
                   response.mean.tangent(1, 2)[0];
          }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        least                                       = std::min(least, seconds.count());
      }
    return least;
  }
} // namespace

int
main()
{
  const std::vector<Points> points = some_points();
  const double n                   = static_cast<double>(points.size()) * Lanes::n_lanes;
  double sum                       = 0.;
  std::cout << version_string() << "\nM, dM/dH and psi of a laminate, a third of the points mixed"
            << std::endl;
  for (const auto &[name, model] : std::vector<std::pair<const char *, MagnetizationModel>>{
         {"linear", MagnetizationLaw::linear},
         {"Langevin", MagnetizationLaw::langevin},
         {"table of 40 points", table({8.2e4, 0.91})}})
    std::printf("%-18s %5.1f ns per point\n", name, 1e9 * time_of(model, points, sum) / n);
  return sum == 0.;
}
