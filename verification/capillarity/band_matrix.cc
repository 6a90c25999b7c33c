#include <verification/capillarity/band_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace magmpm::verification
{
  BandMatrix::BandMatrix(const int n, const int width)
    : n(n)
    , width(width)
    , rows(static_cast<std::size_t>(n) * (width + 1), 0.)
  {
  }

  void
  BandMatrix::isolate(const int i)
  {
    for (int j = std::max(0, i - width); j < i; ++j)
      row(i)[j] = 0.;
    for (int j = i + 1; j <= std::min(n - 1, i + width); ++j)
      row(j)[i] = 0.;
    row(i)[i] = 1.;
  }

  void
  BandMatrix::factorize()
  {
    for (int i = 0; i < n; ++i)
      {
        double *a = row(i);
        for (int j = std::max(0, i - width); j <= i; ++j)
          {
            const double *b = row(j);
            double sum      = a[j];
            for (int k = std::max(0, i - width); k < j; ++k)
              sum -= a[k] * b[k];
            a[j] = j < i ? sum / b[j] : std::sqrt(sum);
          }
      }
  }

  void
  BandMatrix::solve(std::vector<double> &x) const
  {
    for (int i = 0; i < n; ++i)
      {
        for (int j = std::max(0, i - width); j < i; ++j)
          x[i] -= row(i)[j] * x[j];
        x[i] /= row(i)[i];
      }
    for (int i = n; i-- > 0;)
      {
        x[i] /= row(i)[i];
        for (int j = std::max(0, i - width); j < i; ++j)
          x[j] -= row(i)[j] * x[i];
      }
  }
} // namespace magmpm::verification
