#include <verification/capillarity/particle_file.h>

#include <cmath>
#include <fstream>
#include <random>

namespace magmpm::verification
{
  std::string
  write_particles(const std::string &name,
                  const ParticleGrid &grid,
                  const std::function<bool(const std::array<double, 3> &)> &is_inside,
                  const std::function<void(std::array<double, 3> &)> &move)
  {
    std::ofstream file(name + ".csv");
    file.precision(15);
    std::mt19937 random(grid.seed);
    const auto offset = [&]() {
      return 0.5 * grid.jitter * grid.spacing * (2. * (random() / 4294967296.) - 1.);
    };
    long n[3] = {1, 1, 1};
    for (int d = 0; d < grid.dim; ++d)
      n[d] = std::lround(grid.upper[d] / grid.spacing);
    for (long k = 0; k < n[2]; ++k)
      for (long j = 0; j < n[1]; ++j)
        for (long i = 0; i < n[0]; ++i)
          {
            const long index[3]         = {i, j, k};
            std::array<double, 3> place = {};
            for (int d = 0; d < grid.dim; ++d)
              place[d] = (index[d] + 0.5) * grid.spacing + offset();
            if (!is_inside(place))
              continue;
            if (move)
              move(place);
            for (int d = 0; d < grid.dim; ++d)
              file << (d > 0 ? ", " : "") << place[d];
            file << '\n';
          }
    return name + ".csv";
  }
} // namespace magmpm::verification
