#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>

#include <boost/math/special_functions/binomial.hpp>
#include <boost/math/special_functions/factorials.hpp>
#include <verification/magnetostatics/two_spheres.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi      = constants::pi;
    constexpr int n_degrees  = 60; ///< of the multipoles; (2 n_degrees)! is still a double
    constexpr int max_rounds = 2000;
    constexpr int n_spheres  = 2;

    enum Direction
    {
      along, ///< the line of centres
      across
    };

    double
    sign(const int exponent)
    {
      return exponent % 2 == 0 ? 1. : -1.;
    }

    /**
     * The potential around a sphere in harmonics of degree l and one order, distances in units of
     * that of the centres. In 3D the order m is 0 (along) or 1 (across) and the harmonics are
     *   regular r^l P_l^m/(l+m)!, singular (l-m)! P_l^m/r^(l+1);
     * in 2D they are z^l and z^-l of the complex z, the real part (along) or the imaginary
     * (across).
     */
    template <int dim>
    struct Harmonics
    {
      Direction direction;

      /** The regular harmonic of degree 1 is this times that of the uniform field 1. */
      double
      uniform_field() const
      {
        return dim == 3 && direction == across ? 2. : -1.;
      }

      /** Dipole moment of the singular harmonic of degree 1. */
      double
      moment() const
      {
        return (direction == along ? 1. : -1.) * (dim == 3 ? 4. : 2.) * pi;
      }

      /** The singular harmonic with which a sphere answers the regular one of degree l. */
      double
      answer(const int l, const double radius, const double chi) const
      {
        if constexpr (dim == 2)
          return (direction == along ? -1. : 1.) * chi / (chi + 2.) * std::pow(radius, 2 * l);
        const int m = direction;
        return -l * chi / (l * chi + 2. * l + 1.) * std::pow(radius, 2 * l + 1) /
               (boost::math::factorial<double>(l - m) * boost::math::factorial<double>(l + m));
      }

      /**
       * The regular harmonic of degree k about one centre that the singular one of degree l about
       * the other makes; @p from_second: the other is the second sphere.
       */
      double
      translation(const int k, const int l, const bool from_second) const
      {
        if constexpr (dim == 2)
          return sign(from_second ? l : k) *
                 boost::math::binomial_coefficient<double>(l + k - 1, k);
        return sign((from_second ? l : k) + direction) * boost::math::factorial<double>(l + k);
      }
    };

    /** Moments of the two spheres in a field of 1 along the direction; distances in units of d. */
    template <int dim>
    std::array<double, n_spheres>
    unit_moments(const Direction direction,
                 const std::array<double, n_spheres> &radius,
                 const std::array<double, n_spheres> &chi)
    {
      const Harmonics<dim> harmonics = {direction};
      std::array<std::vector<double>, n_spheres> singular, answers, translations;
      for (int s = 0; s < n_spheres; ++s)
        {
          singular[s].assign(n_degrees + 1, 0.);
          answers[s].assign(n_degrees + 1, 0.);
          for (int l = 1; l <= n_degrees; ++l)
            {
              answers[s][l] = harmonics.answer(l, radius[s], chi[s]);
              for (int k = 1; k <= n_degrees; ++k)
                translations[s].push_back(harmonics.translation(l, k, s == 0));
            }
        }

      double change = 1.;
      for (int round = 0; round < max_rounds && change > 1e-13; ++round)
        {
          change = 0.;
          for (int s = 0; s < n_spheres; ++s)
            for (int l = 1; l <= n_degrees; ++l)
              {
                double regular          = (l == 1 ? harmonics.uniform_field() : 0.);
                const double *const row = &translations[s][(l - 1) * n_degrees];
                for (int k = 1; k <= n_degrees; ++k)
                  regular += row[k - 1] * singular[1 - s][k];
                const double value = answers[s][l] * regular;
                change = std::max(change, std::abs(value - singular[s][l]) / std::abs(value));
                singular[s][l] = value;
              }
        }
      if (change > 1e-13)
        throw RunError("the reflections between two spheres do not converge: they are too close.");
      return {harmonics.moment() * singular[0][1], harmonics.moment() * singular[1][1]};
    }

    /** Moments over field [m^dim], along and across the line of centres. */
    template <int dim>
    std::array<double, n_spheres>
    polarizabilities(const Direction direction,
                     const TwoSpheres<dim> &spheres,
                     const double distance)
    {
      std::array<double, n_spheres> result =
        unit_moments<dim>(direction,
                          {spheres.radius[0] / distance, spheres.radius[1] / distance},
                          spheres.susceptibility);
      for (double &value : result)
        value *= std::pow(distance, dim);
      return result;
    }

    /** d/dD of the sum of the two, central difference of fourth order. */
    template <int dim>
    double
    derivative(const Direction direction, const TwoSpheres<dim> &spheres, const double distance)
    {
      const double h   = 1e-3 * distance;
      const auto total = [&](const double shift) {
        const auto both = polarizabilities<dim>(direction, spheres, distance + shift);
        return both[0] + both[1];
      };
      return (8. * (total(h) - total(-h)) - (total(2. * h) - total(-2. * h))) / (12. * h);
    }
  } // namespace

  template <int dim>
  TwoSpheresSolution<dim>
  two_spheres_in_uniform_field(const TwoSpheres<dim> &spheres, const Vector<dim> &outer_field)
  {
    const double distance = norm(spheres.separation);
    if (distance <= spheres.radius[0] + spheres.radius[1])
      throw RunError("two spheres overlap; there is no exact solution for these.");
    const Vector<dim> e            = (1. / distance) * spheres.separation;
    const double field_along       = dot(outer_field, e);
    const Vector<dim> field_across = outer_field - field_along * e;
    const auto alpha_along         = polarizabilities<dim>(along, spheres, distance);
    const auto alpha_across        = polarizabilities<dim>(across, spheres, distance);

    TwoSpheresSolution<dim> solution;
    double anisotropy = 0.;
    for (int s = 0; s < n_spheres; ++s)
      {
        solution.moment[s] = alpha_along[s] * field_along * e + alpha_across[s] * field_across;
        anisotropy += alpha_along[s] - alpha_across[s];
      }
    const double pull = derivative<dim>(along, spheres, distance) * field_along * field_along +
                        derivative<dim>(across, spheres, distance) * norm_square(field_across);
    const double turn = 2. * anisotropy * field_along / distance;

    solution.force_on_second = (0.5 * constants::vacuum_permeability) *
                               (pull * e + turn * field_across);
    return solution;
  }

  template TwoSpheresSolution<2>
  two_spheres_in_uniform_field(const TwoSpheres<2> &, const Vector<2> &);
  template TwoSpheresSolution<3>
  two_spheres_in_uniform_field(const TwoSpheres<3> &, const Vector<3> &);
} // namespace magmpm::verification
