#include <magmpm/base/constants.h>

#include <verification/capillarity/extremum.h>
#include <verification/capillarity/magnetic_spheroid.h>
#include <verification/magnetostatics/exact_magnetostatics.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi = constants::pi;

    /** Of an ellipse, or a prolate spheroid, of the area of the unit circle, or the volume of the unit ball. */
    double
    surface(const int dim, const double aspect)
    {
      const double b = std::pow(aspect, -1. / dim), e = std::sqrt(1. - 1. / (aspect * aspect));
      if (dim == 2)
        return 4. * aspect * b * std::comp_ellint_2(e);
      return 2. * pi * b * b * (1. + (e > 1e-6 ? aspect / e * std::asin(e) : 1.));
    }

    /** M/H_0 times half the volume. */
    double
    magnetic_share(const MagneticDrop &drop, const double aspect)
    {
      const double chi = drop.susceptibility;
      const double n   = drop.dim == 2 ? demagnetizing_factors<2>({{aspect, 1.}})[0]
                                       : demagnetizing_factors<3>({{aspect, 1., 1.}})[0];
      return 0.5 * (drop.dim == 2 ? pi : 4. / 3. * pi) * chi / (1. + chi * n);
    }
  } // namespace

  double
  spheroid_energy(const MagneticDrop &drop, const double bond_number, const double aspect)
  {
    return surface(drop.dim, aspect) - bond_number * magnetic_share(drop, aspect);
  }

  double
  bond_number_of_aspect(const MagneticDrop &drop, const double aspect)
  {
    const double h = 1e-4 * (aspect - 1.), more = aspect + h, less = aspect - h;
    return (surface(drop.dim, more) - surface(drop.dim, less)) /
           (magnetic_share(drop, more) - magnetic_share(drop, less));
  }

  std::optional<Hysteresis>
  hysteresis(const MagneticDrop &drop)
  {
    // In steps of 1 % of K, then between the neighbours of the highest and the lowest.
    const auto bond = [&drop](const double aspect) { return bond_number_of_aspect(drop, aspect); };
    constexpr double step = 1.01, longest = 1e3;
    double up = 1.01;
    while (up < longest && bond(up * step) > bond(up))
      up *= step;
    if (up >= longest)
      return std::nullopt;
    double down = up * step;
    while (down < longest && bond(down * step) < bond(down))
      down *= step;
    const double highest =
      place_of_minimum([&](const double k) { return -bond(k); }, up / step, up * step);
    const double lowest = place_of_minimum(bond, down / step, down * step);
    return Hysteresis{highest, bond(highest), lowest, bond(lowest)};
  }

  double
  spheroid_aspect(const MagneticDrop &drop, const double bond_number)
  {
    double below = 1. + 1e-6, above = below;
    while (bond_number_of_aspect(drop, above) < bond_number)
      {
        below = above;
        above = 1. + 1.01 * (above - 1.) + 1e-4;
      }
    for (int i = 0; i < 60; ++i)
      {
        const double middle                                                 = 0.5 * (below + above);
        (bond_number_of_aspect(drop, middle) < bond_number ? below : above) = middle;
      }
    return 0.5 * (below + above);
  }
} // namespace magmpm::verification
