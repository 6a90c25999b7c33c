#include <magmpm/base/constants.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <verification/mechanics/inviscid_collapse.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    using Values = std::vector<double>;

    /** The free surface from the wall, x = 0, to the tip on the ground, y = 0; a = 1, g = 1. */
    struct Surface
    {
      Values x, y, potential;

      std::size_t
      size() const
      {
        return x.size();
      }

      /** The length of the polygon up to each node. */
      Values
      lengths() const
      {
        Values s(size(), 0.);
        for (std::size_t i = 1; i < size(); ++i)
          s[i] = s[i - 1] + std::hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
        return s;
      }
    };

    /** Rates of change of a Surface. */
    using Rates = Surface;

    Surface
    moved(const Surface &surface, const Rates &rates, const double time)
    {
      Surface result = surface;
      for (std::size_t i = 0; i < surface.size(); ++i)
        {
          result.x[i] += time * rates.x[i];
          result.y[i] += time * rates.y[i];
          result.potential[i] += time * rates.potential[i];
        }
      result.x.front() = result.y.back() = 0.;
      return result;
    }

    // --- Splines ------------------------------------------------------------------------------

    /** How a quantity goes on as an image behind an end: with the same or with the opposite sign. */
    enum class Image
    {
      even, ///< no slope
      odd   ///< no curvature
    };

    /** Cubic spline through values at ascending places. */
    class Spline
    {
    public:
      Spline(const Values &places, const Values &values, const Image first, const Image last);

      double
      value(const double place) const;

      double
      slope(const std::size_t node) const;

    private:
      Values s, f, curvature;
    };

    /** Thomas' algorithm for the curvatures at the nodes. */
    Spline::Spline(const Values &places, const Values &values, const Image first, const Image last)
      : s(places)
      , f(values)
      , curvature(values.size(), 0.)
    {
      const std::size_t n = s.size();
      Values lower(n, 0.), diagonal(n, 1.), upper(n, 0.), right(n, 0.);
      const auto slope_of = [this](const std::size_t i) {
        return (f[i + 1] - f[i]) / (s[i + 1] - s[i]);
      };
      for (std::size_t i = 1; i + 1 < n; ++i)
        {
          lower[i]    = (s[i] - s[i - 1]) / 6.;
          diagonal[i] = (s[i + 1] - s[i - 1]) / 3.;
          upper[i]    = (s[i + 1] - s[i]) / 6.;
          right[i]    = slope_of(i) - slope_of(i - 1);
        }
      if (first == Image::even)
        {
          diagonal[0] = (s[1] - s[0]) / 3.;
          upper[0]    = (s[1] - s[0]) / 6.;
          right[0]    = slope_of(0);
        }
      if (last == Image::even)
        {
          diagonal[n - 1] = (s[n - 1] - s[n - 2]) / 3.;
          lower[n - 1]    = (s[n - 1] - s[n - 2]) / 6.;
          right[n - 1]    = -slope_of(n - 2);
        }
      for (std::size_t i = 1; i < n; ++i)
        {
          const double factor = lower[i] / diagonal[i - 1];
          diagonal[i] -= factor * upper[i - 1];
          right[i] -= factor * right[i - 1];
        }
      curvature[n - 1] = right[n - 1] / diagonal[n - 1];
      for (std::size_t i = n - 1; i-- > 0;)
        curvature[i] = (right[i] - upper[i] * curvature[i + 1]) / diagonal[i];
    }

    double
    Spline::value(const double place) const
    {
      const auto after    = std::upper_bound(s.begin() + 1, s.end() - 1, place);
      const std::size_t j = after - s.begin(), i = j - 1;
      const double h = s[j] - s[i], b = (place - s[i]) / h, a = 1. - b;
      return a * f[i] + b * f[j] +
             ((a * a * a - a) * curvature[i] + (b * b * b - b) * curvature[j]) * h * h / 6.;
    }

    double
    Spline::slope(const std::size_t node) const
    {
      const std::size_t i = std::min(node, s.size() - 2);
      const double h = s[i + 1] - s[i], secant = (f[i + 1] - f[i]) / h;
      return node == i ? secant - h / 6. * (2. * curvature[i] + curvature[i + 1])
                       : secant + h / 6. * (curvature[i] + 2. * curvature[i + 1]);
    }

    /** The splines of x, y and the potential along the surface. */
    std::array<Spline, 3>
    splines(const Surface &surface)
    {
      const Values s = surface.lengths();
      return {Spline(s, surface.x, Image::odd, Image::even),
              Spline(s, surface.y, Image::even, Image::odd),
              Spline(s, surface.potential, Image::even, Image::even)};
    }

    // --- Boundary elements --------------------------------------------------------------------

    /** Integrals over a straight element of log r and of its derivative along the normal, times 1 - s and s. */
    struct ElementIntegrals
    {
      double single[2], twofold[2];
    };

    /** The antiderivatives are those in the place along the element, at a distance of it that is constant. */
    ElementIntegrals
    integrate(const double ax,
              const double ay,
              const double bx,
              const double by,
              const double px,
              const double py)
    {
      const double length = std::hypot(bx - ax, by - ay);
      const double tx = (bx - ax) / length, ty = (by - ay) / length;
      const double distance = (ay - py) * tx - (ax - px) * ty; // along the outer normal (-t_y, t_x)
      const double begin    = (ax - px) * tx + (ay - py) * ty;
      double sums[4]        = {0., 0., 0., 0.}; // log r, s log r, d/r^2, s d/r^2
      for (const int end : {0, 1})
        {
          const double sign   = end == 0 ? -1. : 1.;
          const double s      = begin + end * length;
          const double square = s * s + distance * distance;
          const double log_r  = square > 1e-24 * length * length ? 0.5 * std::log(square) : 0.;
          const double angle  = std::abs(distance) > 1e-12 * length
                                  ? std::atan2(s, std::abs(distance))
                                  : 0.;
          sums[0] += sign * (s * log_r - s + std::abs(distance) * angle);
          sums[1] += sign * (0.5 * square * log_r - 0.25 * square);
          sums[2] += sign * std::copysign(1., distance) * angle;
          sums[3] += sign * distance * log_r;
        }
      const double s1 = (sums[1] - begin * sums[0]) / length,
                   d1 = (sums[3] - begin * sums[2]) / length;
      return {{sums[0] - s1, s1}, {sums[2] - d1, d1}};
    }

    /** The flux dphi/dn out of the fluid at the nodes. */
    Values
    flux(const Surface &surface)
    {
      const std::size_t n = surface.size();
      dealii::LAPACKFullMatrix<double> matrix(n);
      dealii::Vector<double> right(n);
      std::array<Values, 2> row = {Values(n), Values(n)};
      for (std::size_t i = 0; i < n; ++i)
        {
          for (Values &part : row)
            std::fill(part.begin(), part.end(), 0.);
          for (const double sx : {1., -1.})
            for (const double sy : {1., -1.})
              for (std::size_t j = 0; j + 1 < n; ++j)
                {
                  const ElementIntegrals integrals = integrate(surface.x[j],
                                                               surface.y[j],
                                                               surface.x[j + 1],
                                                               surface.y[j + 1],
                                                               sx * surface.x[i],
                                                               sy * surface.y[i]);
                  for (const int end : {0, 1})
                    {
                      row[0][j + end] += integrals.single[end];
                      row[1][j + end] += integrals.twofold[end];
                    }
                }
          // A potential that is the same everywhere has no flux: that gives the angle at the node.
          for (std::size_t j = 0; j < n; ++j)
            {
              matrix(i, j) = row[0][j];
              right[i] += row[1][j] * (surface.potential[j] - surface.potential[i]);
            }
        }
      matrix.compute_lu_factorization();
      matrix.solve(right);
      return {right.begin(), right.end()};
    }

    /** Nodes move with the fluid; dphi/dt there is v^2/2 - g y. */
    Rates
    rates_of(const Surface &surface)
    {
      const Values normal      = flux(surface);
      const auto [x, y, along] = splines(surface);
      Rates rates              = surface;
      for (std::size_t i = 0; i < surface.size(); ++i)
        {
          const double size = std::hypot(x.slope(i), y.slope(i));
          const double tx = x.slope(i) / size, ty = y.slope(i) / size, v = along.slope(i) / size;
          rates.x[i]         = v * tx - normal[i] * ty;
          rates.y[i]         = v * ty + normal[i] * tx;
          rates.potential[i] = 0.5 * (v * v + normal[i] * normal[i]) - surface.y[i];
        }
      rates.x.front() = rates.y.back() = 0.;
      return rates;
    }

    Surface
    after_step(const Surface &start, const double time_step)
    {
      const Rates k1 = rates_of(start);
      const Rates k2 = rates_of(moved(start, k1, 0.5 * time_step));
      const Rates k3 = rates_of(moved(start, k2, 0.5 * time_step));
      const Rates k4 = rates_of(moved(start, k3, time_step));
      Surface result = moved(start, k1, time_step / 6.);
      result         = moved(result, k2, time_step / 3.);
      result         = moved(result, k3, time_step / 3.);
      return moved(result, k4, time_step / 6.);
    }

    /** New nodes on the splines, about four times as dense at the tip as 1 away from it. */
    Surface
    with_new_nodes(const Surface &surface, const int n_nodes)
    {
      const Values s      = surface.lengths();
      const double length = s.back();
      const auto density  = [length](const double place) {
        return 1. / (0.25 + 0.75 * std::min(length - place, 1.));
      };
      Values count(s.size(), 0.);
      for (std::size_t i = 1; i < s.size(); ++i)
        count[i] = count[i - 1] + 0.5 * (density(s[i]) + density(s[i - 1])) * (s[i] - s[i - 1]);
      const auto [x, y, potential] = splines(surface);
      Surface result;
      for (int i = 0; i < n_nodes; ++i)
        {
          const double wanted = count.back() * i / (n_nodes - 1.);
          const auto after    = std::upper_bound(count.begin() + 1, count.end() - 1, wanted);
          const std::size_t j = after - count.begin();
          const double place  = s[j - 1] + (s[j] - s[j - 1]) * (wanted - count[j - 1]) /
                                            (count[j] - count[j - 1]);
          result.x.push_back(x.value(place));
          result.y.push_back(y.value(place));
          result.potential.push_back(potential.value(place));
        }
      result.x.front() = result.y.back() = 0.;
      return result;
    }

    /** Takes zigzags of the nodes away: (-1, 4, 10, 4, -1)/16, with the images behind both ends. */
    Values
    smoothed(const Values &values, const double first, const double last)
    {
      const int n   = static_cast<int>(values.size());
      const auto at = [&](const int i) {
        return i < 0 ? first * values[-i] : i >= n ? last * values[2 * n - 2 - i] : values[i];
      };
      Values result(n);
      for (int i = 0; i < n; ++i)
        result[i] = (10. * at(i) + 4. * (at(i - 1) + at(i + 1)) - (at(i - 2) + at(i + 2))) / 16.;
      return result;
    }

    void
    smooth(Surface &surface)
    {
      surface.x         = smoothed(surface.x, -1., 1.);
      surface.y         = smoothed(surface.y, 1., -1.);
      surface.potential = smoothed(surface.potential, 1., 1.);
    }

    Surface
    column(const int n_nodes)
    {
      constexpr double radius = 0.06;
      Surface surface;
      for (int i = 0; i < 40; ++i)
        {
          surface.x.push_back((1. - radius) * i / 40.);
          surface.y.push_back(2.);
        }
      for (int i = 0; i < 12; ++i)
        {
          const double angle = 0.5 * constants::pi * i / 12.;
          surface.x.push_back(1. - radius + radius * std::sin(angle));
          surface.y.push_back(2. - radius + radius * std::cos(angle));
        }
      for (int i = 0; i <= 80; ++i)
        {
          surface.x.push_back(1.);
          surface.y.push_back((2. - radius) * (80 - i) / 80.);
        }
      surface.potential.assign(surface.size(), 0.);
      return with_new_nodes(surface, n_nodes);
    }

    /** The area under the surface beyond @p least; where it hangs over it is taken away again. */
    double
    area_beyond(const Surface &surface, const double least)
    {
      double area = 0.;
      for (std::size_t i = 1; i < surface.size(); ++i)
        {
          double x0 = surface.x[i - 1], y0 = surface.y[i - 1], x1 = surface.x[i], y1 = surface.y[i];
          if (std::max(x0, x1) <= least)
            continue;
          const double y_there = y0 + (y1 - y0) * (least - x0) / (x1 - x0);
          if (x0 < least)
            {
              x0 = least;
              y0 = y_there;
            }
          else if (x1 < least)
            {
              x1 = least;
              y1 = y_there;
            }
          area += 0.5 * (y0 + y1) * (x1 - x0);
        }
      return area;
    }

    double
    place_with_ahead(const Surface &surface, const double area)
    {
      double behind = 0., ahead = surface.x.back();
      for (int i = 0; i < 60; ++i)
        {
          const double middle                                    = 0.5 * (behind + ahead);
          (area_beyond(surface, middle) > area ? behind : ahead) = middle;
        }
      return behind;
    }
  } // namespace

  std::vector<InviscidFront>
  inviscid_fronts(const std::vector<double> &times, const int n_nodes)
  {
    const double longest_step = 0.6 /
                                n_nodes; // with longer ones nodes that are so dense begin to zigzag
    Surface surface   = column(n_nodes);
    const double area = area_beyond(surface, 0.);
    double time       = 0.;
    int n_steps       = 0;
    std::vector<InviscidFront> fronts;
    for (const double wanted : times)
      {
        const double end = wanted / std::sqrt(2.);
        const int n      = static_cast<int>(std::ceil((end - time) / longest_step));
        for (int i = 0; i < n; ++i)
          {
            surface = after_step(surface, (end - time) / n);
            if (++n_steps % 5 == 0)
              smooth(surface);
            surface = with_new_nodes(surface, n_nodes);
          }
        time             = end;
        const double now = area_beyond(surface, 0.);
        fronts.push_back(
          {wanted, place_with_ahead(surface, 0.005 * now), surface.x.back(), now / area - 1.});
      }
    return fronts;
  }
} // namespace magmpm::verification
