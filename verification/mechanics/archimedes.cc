#include <magmpm/base/constants.h>

#include <verification/mechanics/archimedes.h>

#include <algorithm>
#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    /** The mass of fluid that a body displaces whose lowest point is at a depth [m]. */
    double
    displaced_mass(const Pool &pool, const Floater &floater, const double immersion)
    {
      constexpr int n = 2000; // of the midpoint rule
      double sum      = 0.;
      for (int i = 0; i < n; ++i)
        {
          const double depth = immersion * (i + 0.5) / n;
          sum += pool.density_at(depth) *
                 floater.section(pool.dim, immersion - depth - floater.half_height());
        }
      return sum * immersion / n;
    }
  } // namespace

  // dp/dz = rho_0 g/J with J = 1 - p/K: p - p^2/(2 K) = rho_0 g z.
  double
  Pool::density_at(const double depth) const
  {
    return density / std::sqrt(1. - 2. * density * gravity * depth / bulk_modulus);
  }

  // J = 1 - rho_0 g/K times the undeformed height of what is above.
  double
  Pool::level() const
  {
    return depth * (1. - 0.5 * density * gravity * depth / bulk_modulus);
  }

  double
  Floater::volume(const int dim) const
  {
    if (!is_round)
      return std::pow(2. * half_size, dim);
    return dim == 2 ? constants::pi * std::pow(half_size, 2)
                    : 4. / 3. * constants::pi * std::pow(half_size, 3);
  }

  double
  Floater::half_height() const
  {
    return is_round ? half_size : half_size * (std::abs(std::cos(turn)) + std::abs(std::sin(turn)));
  }

  // That of a turned square is even between the two middle corners and ends at the others.
  double
  Floater::section(const int dim, const double height) const
  {
    const double from_end = half_height() - std::abs(height);
    if (from_end <= 0.)
      return 0.;
    if (is_round)
      {
        const double square = half_size * half_size - height * height;
        return dim == 2 ? 2. * std::sqrt(square) : constants::pi * square;
      }
    const double less   = std::min(std::abs(std::cos(turn)), std::abs(std::sin(turn)));
    const double more   = std::sqrt(1. - less * less);
    const double corner = 2. * half_size * less; // of its height below the even part
    const double length = 2. * half_size / more * (from_end < corner ? from_end / corner : 1.);
    return dim == 2 ? length : 2. * half_size * length;
  }

  double
  floating_height(const Pool &pool, const Floater &floater)
  {
    const double mass = floater.density * floater.volume(pool.dim);
    double immersion = 0., above = 2. * floater.half_height();
    for (int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (immersion + above);
        (displaced_mass(pool, floater, middle) < mass ? immersion : above) = middle;
      }
    // The fluid around it does not notice whether there is the body or what that displaces.
    Pool fuller = pool;
    fuller.depth += mass / (pool.density * std::pow(pool.width, pool.dim - 1));
    return fuller.level() - immersion + floater.half_height();
  }
} // namespace magmpm::verification
