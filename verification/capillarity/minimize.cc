#include <verification/capillarity/minimize.h>

#include <cmath>
#include <cstddef>
#include <numeric>

namespace magmpm::verification
{
  namespace
  {
    using Values = std::vector<double>;

    double
    product(const Values &a, const Values &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }

    Values
    sum(const Values &a, const double factor, const Values &b)
    {
      Values result = a;
      for (std::size_t i = 0; i < a.size(); ++i)
        result[i] += factor * b[i];
      return result;
    }

    double
    size(const Values &a)
    {
      return std::sqrt(product(a, a));
    }

    /**
     * Whether a step has led down far enough; where the values differ by no more than they are rounded, the gradients
     * tell.
     */
    bool
    is_better(const ValueAndGradient &next, const ValueAndGradient &now, const double fall)
    {
      constexpr double rounding = 1e-10;
      return next.value <= now.value - fall ||
             (next.value <= now.value + rounding * (1. + std::abs(now.value)) &&
              size(next.gradient) < 0.5 * size(now.gradient));
    }

    /** The inverse of the second derivatives as the gradients on the way tell it. */
    class InverseHessian
    {
    public:
      InverseHessian(const std::size_t n, const double scale)
        : rows(n, Values(n, 0.))
      {
        for (std::size_t i = 0; i < n; ++i)
          rows[i][i] = scale;
      }

      Values
      operator*(const Values &x) const
      {
        Values result;
        for (const Values &row : rows)
          result.push_back(product(row, x));
        return result;
      }

      void
      update(const Values &step, const Values &change)
      {
        const double along = product(step, change);
        if (along <= 0.)
          return;
        const Values h      = *this * change;
        const double square = (1. + product(change, h) / along) / along;
        for (std::size_t i = 0; i < step.size(); ++i)
          for (std::size_t j = 0; j < step.size(); ++j)
            rows[i][j] += square * step[i] * step[j] - (h[i] * step[j] + step[i] * h[j]) / along;
      }

    private:
      std::vector<Values> rows;
    };
  } // namespace

  Minimum
  minimize(const SmoothFunction &function,
           const std::vector<double> &start,
           const double first_step,
           const double tolerance)
  {
    Values place         = start;
    ValueAndGradient now = function(place);
    double slope         = size(now.gradient);
    if (slope <= tolerance)
      return {place, now.value, slope};
    InverseHessian inverse(start.size(), first_step / slope);
    for (int i = 0; i < 200 && slope > tolerance; ++i)
      {
        const Values direction = inverse * now.gradient;
        const double promise   = product(direction, now.gradient);
        double length          = 1.;
        ValueAndGradient next  = now;
        do
          {
            next = function(sum(place, -length, direction));
            length *= 0.5;
          }
        while (!is_better(next, now, 2e-4 * length * promise) && length > 1e-12);
        if (length <= 1e-12)
          break; // rounding
        const Values step = sum(Values(start.size(), 0.), -2. * length, direction);
        place             = sum(place, 1., step);
        inverse.update(step, sum(next.gradient, -1., now.gradient));
        now   = next;
        slope = size(now.gradient);
      }
    return {place, now.value, slope};
  }
} // namespace magmpm::verification
