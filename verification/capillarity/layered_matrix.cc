#include <magmpm/base/constants.h>

#include <verification/capillarity/layered_matrix.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  LayeredMatrix::LayeredMatrix(const CosineElements &elements,
                               const std::vector<double> &across,
                               const std::vector<double> &along)
    : n_nodes(elements.nodes_per_pair())
  {
    const CosineElements::Direction &x = elements.direction(0), &y = elements.direction(1);
    const int width = static_cast<int>(elements.column().front().values.size()) - 1;
    for (std::size_t i = 0; i < x.n; ++i)
      for (std::size_t j = 0; j < y.n; ++j)
        {
          const double square = std::pow(i * constants::pi / x.width, 2) +
                                std::pow(j * constants::pi / y.width, 2);
          const double area    = x.width * y.width * (i > 0 ? 0.5 : 1.) * (j > 0 ? 0.5 : 1.);
          const double bending = std::max(square, 1e-6 / (x.width * y.width));
          BandMatrix band(static_cast<int>(n_nodes), width);
          for (std::size_t q = 0; q < elements.column().size(); ++q)
            {
              const CosineElements::Height &height = elements.column()[q];
              for (int a = 0; a <= width; ++a)
                for (int b = 0; b <= a; ++b)
                  band.add(static_cast<int>(height.first) + a,
                           static_cast<int>(height.first) + b,
                           area * height.weight *
                             (bending * across[q] * height.values[a] * height.values[b] +
                              along[q] * height.slopes[a] * height.slopes[b]));
            }
          band.factorize();
          bands.push_back(band);
        }
  }

  std::vector<double>
  LayeredMatrix::solve(const std::vector<double> &right) const
  {
    std::vector<double> result;
    for (std::size_t pair = 0; pair < bands.size(); ++pair)
      {
        std::vector<double> part(right.begin() + pair * n_nodes,
                                 right.begin() + (pair + 1) * n_nodes);
        bands[pair].solve(part);
        result.insert(result.end(), part.begin(), part.end());
      }
    return result;
  }
} // namespace magmpm::verification
