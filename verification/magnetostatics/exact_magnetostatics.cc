#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <verification/magnetostatics/exact_magnetostatics.h>

#include <cmath>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi  = constants::pi;
    constexpr double mu0 = constants::vacuum_permeability;

    /** x with A x = b, by Cramer's rule. */
    template <int dim>
    Vector<dim>
    solve(const Matrix<dim> &a, const Vector<dim> &b)
    {
      Vector<dim> x;
      for (int k = 0; k < dim; ++k)
        {
          Matrix<dim> replaced = a;
          for (int i = 0; i < dim; ++i)
            replaced(i, k) = b[i];
          x[k] = determinant(replaced) / determinant(a);
        }
      return x;
    }

    template <int dim>
    Vector<dim>
    times(const Vector<dim> &factors, Vector<dim> v)
    {
      for (int d = 0; d < dim; ++d)
        v[d] *= factors[d];
      return v;
    }

    /** U = -(mu_0/8 pi) [radial p_r^2 + transverse p_t^2]: these two and their derivatives by D. */
    struct MirrorSums
    {
      double radial                = 0.;
      double transverse            = 0.;
      double radial_derivative     = 0.;
      double transverse_derivative = 0.;
    };

    template <int dim>
    MirrorSums
    mirror_sums(const double chi, const double radius, const double distance)
    {
      MirrorSums sums;
      if constexpr (dim == 2)
        {
          const double gap           = distance * distance - radius * radius;
          sums.radial                = 2. * chi / (chi + 2.) * radius * radius / (gap * gap);
          sums.transverse            = sums.radial;
          sums.radial_derivative     = -4. * distance / gap * sums.radial;
          sums.transverse_derivative = sums.radial_derivative;
        }
      else
        {
          const double ratio = radius * radius / (distance * distance);
          double power       = radius / std::pow(distance, 4);
          double term        = 1.;
          for (int k = 1; term > 1e-18 * sums.radial; ++k)
            {
              const double mirror = k * chi / (k * chi + 2. * k + 1.);
              power *= ratio;
              term                    = mirror * power * (k + 1.) * (k + 1.);
              const double transverse = mirror * power * 0.5 * k * (k + 1.);
              sums.radial += term;
              sums.transverse += transverse;
              sums.radial_derivative -= (2. * k + 4.) / distance * term;
              sums.transverse_derivative -= (2. * k + 4.) / distance * transverse;
            }
        }
      return sums;
    }
  } // namespace

  template <int dim>
  double
  ellipsoid_volume(const Vector<dim> &half_axes)
  {
    double volume = (dim == 3 ? 4. / 3. * pi : pi);
    for (int d = 0; d < dim; ++d)
      volume *= half_axes[d];
    return volume;
  }

  template <int dim>
  Vector<dim>
  demagnetizing_factors(const Vector<dim> &half_axes)
  {
    if constexpr (dim == 2)
      return (1. / (half_axes[0] + half_axes[1])) * Vector<2>{{half_axes[1], half_axes[0]}};
    else
      {
        const auto square    = [&](const int d) { return half_axes[d] * half_axes[d]; };
        const double product = half_axes[0] * half_axes[1] * half_axes[2];
        Vector<dim> factors;
        for (int d = 0; d < dim; ++d)
          factors[d] = product / 3. *
                       boost::math::ellint_rd(square((d + 1) % 3), square((d + 2) % 3), square(d));
        return factors;
      }
  }

  template <int dim>
  UniformState<dim>
  ellipsoid_in_uniform_field(const MagnetizationLaw law,
                             const MagneticContent &content,
                             const Vector<dim> &factors,
                             const Vector<dim> &outer_field)
  {
    const auto residual = [&](const Vector<dim> &field) {
      return field + times(factors, magnetization<dim>(law, content, field)) - outer_field;
    };
    Vector<dim> field = outer_field;
    for (int step = 0; step < 100; ++step)
      {
        const double norm_before = norm(residual(field));
        if (norm_before <= 1e-14 * norm(outer_field))
          return {field, magnetization<dim>(law, content, field)};

        // I + N dM/dH cannot be singular, being similar to a positive definite matrix.
        Matrix<dim> jacobian = magnetic_response<dim>(law, content, field).tangent;
        for (int i = 0; i < dim; ++i)
          {
            for (int j = 0; j < dim; ++j)
              jacobian(i, j) *= factors[i];
            jacobian(i, i) += 1.;
          }
        const Vector<dim> correction = solve(jacobian, residual(field));
        double length                = 1.;
        while (length > 1e-9 && norm(residual(field - length * correction)) >= norm_before)
          length *= 0.5;
        if (length <= 1e-9 && norm_before <= 1e-12 * norm(outer_field))
          return {field, magnetization<dim>(law, content, field)};
        field -= length * correction;
      }
    throw RunError("the field in an ellipsoid was not found in 100 steps of Newton's method.");
  }

  template <int dim>
  UniformState<dim>
  sphere_in_uniform_field(const MagnetizationLaw law,
                          const MagneticContent &content,
                          const Vector<dim> &outer_field)
  {
    Vector<dim> factors;
    for (int d = 0; d < dim; ++d)
      factors[d] = 1. / dim;
    return ellipsoid_in_uniform_field(law, content, factors, outer_field);
  }

  template <int dim>
  Matrix<dim>
  surface_virial_of_sphere(const double volume, const Vector<dim> &magnetization)
  {
    return (0.5 * mu0 * volume / (dim + 2.)) * (norm_square(magnetization) * identity<dim>() +
                                                2. * outer(magnetization, magnetization));
  }

  template <int dim>
  Vector<dim>
  force_of_dipole_on_sphere(const double susceptibility,
                            const double radius,
                            const Vector<dim> &place,
                            const Vector<dim> &dipole)
  {
    // U = -c [(r - t) (p.e)^2 + t p^2], where the gradient of p.e by the dipole's place is
    // (p - (p.e) e)/D.
    const double distance    = norm(place);
    const MirrorSums sums    = mirror_sums<dim>(susceptibility, radius, distance);
    const Vector<dim> e      = (1. / distance) * place;
    const double along       = dot(dipole, e);
    const Vector<dim> across = dipole - along * e;
    const double pull        = sums.radial_derivative * along * along +
                        sums.transverse_derivative * norm_square(across);
    const double turn = 2. * (sums.radial - sums.transverse) * along / distance;
    return (-mu0 / (8. * pi)) * (pull * e + turn * across);
  }

#define MAGMPM_INSTANTIATE(dim)                                                                 \
  template double ellipsoid_volume(const Vector<dim> &);                                        \
  template Vector<dim> demagnetizing_factors(const Vector<dim> &);                              \
  template UniformState<dim> ellipsoid_in_uniform_field(                                        \
    const MagnetizationLaw, const MagneticContent &, const Vector<dim> &, const Vector<dim> &); \
  template UniformState<dim> sphere_in_uniform_field(                                           \
    const MagnetizationLaw, const MagneticContent &, const Vector<dim> &);                      \
  template Matrix<dim> surface_virial_of_sphere(const double, const Vector<dim> &);             \
  template Vector<dim> force_of_dipole_on_sphere(                                               \
    const double, const double, const Vector<dim> &, const Vector<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm::verification
