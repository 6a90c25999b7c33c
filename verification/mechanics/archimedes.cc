#include <magmpm/base/constants.h>

#include <verification/mechanics/archimedes.h>

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
                 floater.section(pool.dim, immersion - depth - floater.half_size);
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
  Floater::section(const int dim, const double height) const
  {
    if (std::abs(height) >= half_size)
      return 0.;
    if (!is_round)
      return std::pow(2. * half_size, dim - 1);
    const double square = half_size * half_size - height * height;
    return dim == 2 ? 2. * std::sqrt(square) : constants::pi * square;
  }

  double
  floating_height(const Pool &pool, const Floater &floater)
  {
    const double mass = floater.density * floater.volume(pool.dim);
    double immersion = 0., above = 2. * floater.half_size;
    for (int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (immersion + above);
        (displaced_mass(pool, floater, middle) < mass ? immersion : above) = middle;
      }
    // The fluid around it does not notice whether there is the body or what that displaces.
    Pool fuller = pool;
    fuller.depth += mass / (pool.density * std::pow(pool.width, pool.dim - 1));
    return fuller.level() - immersion + floater.half_size;
  }
} // namespace magmpm::verification
