#include <verification/capillarity/complex_zero.h>
#include <verification/capillarity/drop_modes.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    using Complex = std::complex<double>;

    /** z I_(order + 1)(z)/I_order(z), by its continued fraction from below. */
    Complex
    bessel_ratio(const double order, const Complex z)
    {
      const int n_terms = 60 + static_cast<int>(2. * std::abs(z));
      Complex ratio     = 0.;
      for (int i = n_terms; i > 0; --i)
        ratio = z / (2. * (order + i) + z * ratio);
      return z * ratio;
    }

    /** Zero where exp(s t) is a motion; lengths in R, times in sqrt(rho R^3/gamma). */
    Complex
    mismatch(const int dim, const int n, const double viscosity, const Complex s)
    {
      const Complex square = s / viscosity, m = std::sqrt(square);
      // The rotation is 1 at the surface and q its slope; no shear tells the potential A r^n beside it.
      const Complex q = static_cast<double>(n) + bessel_ratio(dim == 3 ? n + 0.5 : n, m);
      const double k  = n;
      if (dim == 2)
        {
          const Complex a = (2. * q - 2. * k * k - square) / (2. * k * (k - 1.));
          return s * s * a + 2. * viscosity * s * (k * (k - 1.) * a + k * (q - 1.)) +
                 k * (k * k - 1.) * (a + 1.);
        }
      const double l2 = k * (k + 1.);
      const Complex a = (2. * q - square - 2. * l2 + 2.) / (2. * (k - 1.));
      return s * s * a + 2. * viscosity * s * (k * (k - 1.) * a + l2 * (q - 1.)) +
             (k - 1.) * (k + 2.) * (k * a + l2);
    }
  } // namespace

  double
  Drop::capillary_speed() const
  {
    return std::sqrt(surface_tension / (density * radius));
  }

  double
  drop_frequency(const Drop &drop, const int n)
  {
    const double factor = drop.dim == 2 ? n * (n * n - 1.) : n * (n - 1.) * (n + 2.);
    return drop.capillary_speed() / drop.radius * std::sqrt(factor);
  }

  double
  drop_damping(const Drop &drop, const int n)
  {
    const double factor = drop.dim == 2 ? 2. * n * (n - 1.) : (n - 1.) * (2. * n + 1.);
    return factor * drop.viscosity / (drop.radius * drop.radius);
  }

  std::complex<double>
  drop_rate(const Drop &drop, const int n)
  {
    const double unit       = drop.capillary_speed() / drop.radius;
    const Complex potential = Complex(-drop_damping(drop, n), drop_frequency(drop, n)) / unit;
    if (drop.viscosity == 0.)
      return unit * potential;
    const double viscosity = drop.viscosity / (drop.radius * drop.radius * unit);
    return unit * complex_zero([&](const Complex s) { return mismatch(drop.dim, n, viscosity, s); },
                               potential);
  }
} // namespace magmpm::verification
