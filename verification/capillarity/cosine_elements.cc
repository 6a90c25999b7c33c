#include <magmpm/base/constants.h>

#include <verification/capillarity/cosine_elements.h>
#include <verification/capillarity/gauss_rule.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    using Values = std::vector<double>;

    CosineElements::Direction
    direction_of(const double width, const int n)
    {
      CosineElements::Direction result = {width, static_cast<std::size_t>(n), {}, {}};
      for (int a = 0; a < 2 * n; ++a)
        {
          Values cosines, slopes;
          for (int i = 0; i < n; ++i)
            {
              const double k = i * constants::pi / width, place = (a + 0.5) * 0.5 * width / n;
              cosines.push_back(std::cos(k * place));
              slopes.push_back(-k * std::sin(k * place));
            }
          result.cosines.push_back(cosines);
          result.slopes.push_back(slopes);
        }
      return result;
    }

    /** to += factor from, for n entries from two places on. */
    void
    add(const double factor, const double *from, const std::size_t n, double *to)
    {
      for (std::size_t i = 0; i < n; ++i)
        to[i] += factor * from[i];
    }

    /** A function and its slope along s, at heights, for each pair of cosines. */
    struct PairHeights
    {
      Values values, slopes;
    };

    PairHeights
    at_heights(const CosineElements &elements, const Values &u)
    {
      const std::size_t n_pairs = elements.direction(0).n * elements.direction(1).n;
      PairHeights result;
      for (std::size_t pair = 0; pair < n_pairs; ++pair)
        for (const CosineElements::Height &height : elements.column())
          {
            const double *here = u.data() + pair * elements.nodes_per_pair() + height.first;
            double value = 0., slope = 0.;
            for (std::size_t i = 0; i < height.values.size(); ++i)
              {
                value += height.values[i] * here[i];
                slope += height.slopes[i] * here[i];
              }
            result.values.push_back(value);
            result.slopes.push_back(slope);
          }
      return result;
    }
  } // namespace

  CosineElements::CosineElements(const std::array<double, 2> &widths,
                                 const std::array<int, 2> &n_cosines,
                                 const std::vector<double> &edges,
                                 const int degree)
    : x(direction_of(widths[0], n_cosines[0]))
    , y(direction_of(widths[1], n_cosines[1]))
    , n_nodes(degree * (edges.size() - 1) + 1)
  {
    const GaussRule rule = gauss_rule(degree + 2);
    const Values places  = lobatto_points(degree + 1);
    for (std::size_t e = 0; e + 1 < edges.size(); ++e)
      for (std::size_t q = 0; q < rule.points.size(); ++q)
        {
          const double thickness = edges[e + 1] - edges[e];
          Height height          = {
                     edges[e] + thickness * rule.points[q], thickness * rule.weights[q], e * degree, {}, {}};
          for (int i = 0; i <= degree; ++i)
            {
              const ValueAndSlope polynomial = lagrange(places, i, rule.points[q]);
              height.values.push_back(polynomial.value);
              height.slopes.push_back(polynomial.slope / thickness);
            }
          heights.push_back(height);
        }
    const double dx = 0.5 * x.width / x.n, dy = 0.5 * y.width / y.n;
    for (std::size_t a = 0; a < x.cosines.size(); ++a)
      for (std::size_t b = 0; b < y.cosines.size(); ++b)
        for (const Height &height : heights)
          all_points.push_back({(a + 0.5) * dx, (b + 0.5) * dy, height.s, height.weight * dx * dy});
  }

  std::vector<BoxGradient>
  CosineElements::gradients(const Values &u) const
  {
    const std::size_t n_h = heights.size(), n_y = y.cosines.size();
    const PairHeights pairs = at_heights(*this, u);
    // Along y: u, u_y and u_s for each cosine along x.
    Values value(x.n * n_y * n_h, 0.), by_y = value, by_s = value;
    for (std::size_t i = 0; i < x.n; ++i)
      for (std::size_t b = 0; b < n_y; ++b)
        for (std::size_t j = 0; j < y.n; ++j)
          {
            const std::size_t from = (i * y.n + j) * n_h, to = (i * n_y + b) * n_h;
            add(y.cosines[b][j], &pairs.values[from], n_h, &value[to]);
            add(y.slopes[b][j], &pairs.values[from], n_h, &by_y[to]);
            add(y.cosines[b][j], &pairs.slopes[from], n_h, &by_s[to]);
          }
    std::vector<BoxGradient> result(all_points.size(), BoxGradient{});
    const std::size_t slab = n_y * n_h;
    Values sums[3];
    for (std::size_t a = 0; a < x.cosines.size(); ++a)
      {
        for (Values &sum : sums)
          sum.assign(slab, 0.);
        for (std::size_t i = 0; i < x.n; ++i)
          {
            add(x.slopes[a][i], &value[i * slab], slab, sums[0].data());
            add(x.cosines[a][i], &by_y[i * slab], slab, sums[1].data());
            add(x.cosines[a][i], &by_s[i * slab], slab, sums[2].data());
          }
        for (std::size_t p = 0; p < slab; ++p)
          result[a * slab + p] = {sums[0][p], sums[1][p], sums[2][p]};
      }
    return result;
  }

  std::vector<double>
  CosineElements::tested(const std::vector<BoxGradient> &flux) const
  {
    const std::size_t n_h = heights.size(), n_y = y.cosines.size(), slab = n_y * n_h;
    Values value(x.n * slab, 0.), by_y = value, by_s = value, part(slab);
    for (std::size_t a = 0; a < x.cosines.size(); ++a)
      for (int d = 0; d < 3; ++d)
        {
          for (std::size_t p = 0; p < slab; ++p)
            part[p] = flux[a * slab + p][d];
          Values &to = d == 0 ? value : d == 1 ? by_y : by_s;
          for (std::size_t i = 0; i < x.n; ++i)
            add(d == 0 ? x.slopes[a][i] : x.cosines[a][i], part.data(), slab, &to[i * slab]);
        }
    Values result(x.n * y.n * n_nodes, 0.), values(n_h), slopes(n_h);
    for (std::size_t i = 0; i < x.n; ++i)
      for (std::size_t j = 0; j < y.n; ++j)
        {
          values.assign(n_h, 0.);
          slopes.assign(n_h, 0.);
          for (std::size_t b = 0; b < n_y; ++b)
            {
              const std::size_t from = i * slab + b * n_h;
              add(y.cosines[b][j], &value[from], n_h, values.data());
              add(y.slopes[b][j], &by_y[from], n_h, values.data());
              add(y.cosines[b][j], &by_s[from], n_h, slopes.data());
            }
          double *to = &result[(i * y.n + j) * n_nodes];
          for (std::size_t q = 0; q < n_h; ++q)
            for (std::size_t m = 0; m < heights[q].values.size(); ++m)
              to[heights[q].first + m] += heights[q].values[m] * values[q] +
                                          heights[q].slopes[m] * slopes[q];
        }
    return result;
  }
} // namespace magmpm::verification
