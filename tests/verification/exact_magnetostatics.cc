#include "catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/external_field.h>

#include <verification/magnetostatics/exact_magnetostatics.h>
#include <verification/magnetostatics/jittered_points.h>
#include <verification/magnetostatics/sources.h>
#include <verification/magnetostatics/two_spheres.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr double pi  = constants::pi;
  constexpr double mu0 = constants::vacuum_permeability;

  constexpr MagneticContent soft = {8.2e4, 0.91}; ///< Langevin medium of Sun et al. 2021

  template <int dim>
  Vector<dim>
  same(const double value)
  {
    Vector<dim> v;
    for (int d = 0; d < dim; ++d)
      v[d] = value;
    return v;
  }

  /** A vector of a given length. */
  template <int dim>
  Vector<dim>
  along(const Vector<3> &direction, const double length)
  {
    Vector<dim> v;
    for (int d = 0; d < dim; ++d)
      v[d] = direction[d];
    return (length / norm(v)) * v;
  }

  /** A vector oblique to all axes. */
  template <int dim>
  Vector<dim>
  oblique(const double length)
  {
    return along<dim>({{0.5, -0.3, 0.8}}, length);
  }

  /** Another one. */
  template <int dim>
  Vector<dim>
  other(const double length)
  {
    return along<dim>({{0.4, 0.9, -0.2}}, length);
  }

  template <int dim>
  double
  sphere_volume(const double radius)
  {
    return ellipsoid_volume(same<dim>(radius));
  }

  /** The field of a dipole p in the origin: a small magnetized sphere's. */
  template <int dim>
  ExternalField<dim>
  dipole_source(const Vector<dim> &place, const Vector<dim> &dipole)
  {
    const double radius = 1e-3;
    return ExternalField<dim>(
      {magnet_source(place, radius, (1. / sphere_volume<dim>(radius)) * dipole)});
  }

  template <int dim>
  double
  difference(const Vector<dim> &a, const Vector<dim> &b)
  {
    return norm(a - b) / norm(b);
  }

  /**
   * int f over a ball around the origin: over the directions by a product rule (exact for
   * polynomials of degree 15 in 3D, 31 in 2D), along the radius by Simpson's rule.
   */
  template <int dim, typename Function>
  Vector<dim>
  ball_integral(const double radius, const Function &f)
  {
    constexpr int n_angles = 32, n_shells = 40;
    // Gauss points of 8 on [-1, 1] for cos(theta).
    const double points[] = {
      0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    const double weights[] = {
      0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    Vector<dim> sum;
    for (int shell = 0; shell <= n_shells; ++shell)
      {
        const double r       = radius * shell / n_shells;
        const double simpson = radius / n_shells / 3. *
                               (shell == 0 || shell == n_shells ? 1. : (shell % 2 == 1 ? 4. : 2.));
        const double weight = simpson * std::pow(r, dim - 1) * 2. * pi / n_angles;
        for (int a = 0; a < n_angles; ++a)
          {
            const double angle = 2. * pi * a / n_angles;
            if constexpr (dim == 2)
              sum += weight * f(Vector<2>{{r * std::cos(angle), r * std::sin(angle)}});
            else
              for (int g = 0; g < 8; ++g)
                {
                  const double cosine = (g < 4 ? 1. : -1.) * points[g % 4];
                  const double sine   = std::sqrt(1. - cosine * cosine);
                  sum += weight * weights[g % 4] *
                         f(Vector<3>{
                           {r * sine * std::cos(angle), r * sine * std::sin(angle), r * cosine}});
                }
          }
      }
    return sum;
  }
} // namespace

// Demagnetizing factors sum to 1, are 1/dim of a sphere, follow the axes when these are exchanged,
// and of a 2:1 prolate spheroid have the closed form (1 - e^2)/e^3 (artanh e - e); long needles
// have none along, flat discs 1 across.
TEST_CASE("Demagnetizing factors are those of Osborn", "[verification]")
{
  for (const Vector<3> &axes : {Vector<3>{{1., 2., 3.}}, Vector<3>{{0.1, 5., 0.7}}})
    {
      const Vector<3> n = demagnetizing_factors(axes);
      CHECK(n[0] + n[1] + n[2] == Approx(1.).epsilon(1e-14));
      const Vector<3> turned = demagnetizing_factors<3>({{axes[1], axes[2], axes[0]}});
      for (int d = 0; d < 3; ++d)
        CHECK(turned[d] == Approx(n[(d + 1) % 3]).epsilon(1e-14));
    }
  CHECK(demagnetizing_factors(same<3>(2.))[1] == Approx(1. / 3.).epsilon(1e-14));
  CHECK(demagnetizing_factors(same<2>(2.))[1] == Approx(0.5).epsilon(1e-14));

  const double e = std::sqrt(0.75);
  CHECK(demagnetizing_factors<3>({{2., 1., 1.}})[0] ==
        Approx((1. - e * e) / std::pow(e, 3) * (std::atanh(e) - e)).epsilon(1e-13));
  CHECK(demagnetizing_factors<2>({{2., 1.}})[0] == Approx(1. / 3.).epsilon(1e-14));
  CHECK(demagnetizing_factors<3>({{1e4, 1., 1.}})[0] < 1e-6);
  CHECK(demagnetizing_factors<3>({{1e4, 1e4, 1.}})[2] > 0.999);
}

// Inside an ellipsoid H + N M(H) = H_0 along every axis, whatever the law; of a linear sphere this
// is M = chi H_0/(1 + chi/3), and a Langevin sphere in a huge field is saturated.
TEMPLATE_TEST_CASE_SIG("The field in an ellipsoid fulfils its equation",
                       "[verification]",
                       ((int dim), dim),
                       2,
                       3)
{
  Vector<dim> half_axes;
  for (int d = 0; d < dim; ++d)
    half_axes[d] = 1. + 2. * d;
  const Vector<dim> factors = demagnetizing_factors(half_axes);
  for (const MagnetizationLaw law : {MagnetizationLaw::linear, MagnetizationLaw::langevin})
    for (const double size : {1., 1e5, 1e8})
      for (const double chi : {0.91, 100.})
        {
          const MagneticContent content = {8.2e4, chi};
          const Vector<dim> outer_field = oblique<dim>(size);
          const UniformState<dim> state =
            ellipsoid_in_uniform_field(law, content, factors, outer_field);
          const Vector<dim> m = magnetization<dim>(law, content, state.field);
          for (int d = 0; d < dim; ++d)
            {
              CHECK(state.magnetization[d] == Approx(m[d]).epsilon(1e-12));
              CHECK(state.field[d] + factors[d] * m[d] ==
                    Approx(outer_field[d]).margin(1e-12 * size));
            }
        }

  const auto linear = sphere_in_uniform_field(MagnetizationLaw::linear, soft, oblique<dim>(1e5));
  CHECK(difference(linear.magnetization, 0.91 / (1. + 0.91 / dim) * oblique<dim>(1e5)) < 1e-13);
  const auto saturated =
    sphere_in_uniform_field(MagnetizationLaw::langevin, soft, oblique<dim>(1e9));
  CHECK(norm(saturated.magnetization) == Approx(8.2e4).epsilon(1e-3));
}

// The virial of the surface traction mu_0/2 (M.n)^2 n is its integral over the sphere, done here by
// quadrature.
TEMPLATE_TEST_CASE_SIG("The virial of a sphere is that of its surface traction",
                       "[verification]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double radius   = 0.3;
  const Vector<dim> m   = oblique<dim>(2.);
  const Matrix<dim> all = surface_virial_of_sphere(sphere_volume<dim>(radius), m);
  for (int column = 0; column < dim; ++column)
    {
      // The integral over the surface as one over the ball: int g(n) dS = dim/R int g(n) dV.
      const Vector<dim> exact = ball_integral<dim>(radius, [&](const Vector<dim> &x) {
        const double r = norm(x);
        if (r == 0.)
          return Vector<dim>();
        const Vector<dim> n = (1. / r) * x;
        return (dim / radius * 0.5 * mu0 * std::pow(dot(m, n), 2) * radius * n[column]) * n;
      });
      for (int row = 0; row < dim; ++row)
        CHECK(all(row, column) == Approx(exact[row]).epsilon(1e-10).margin(1e-20));
    }
}

// Far from a dipole the force on a sphere is (m.grad) H of its induced moment m; for vanishing chi
// it is the integral of mu_0 chi (H.grad) H of the dipole's field at any distance; and in 2D,
// where every harmonic is weakened by the same 2/(chi + 2), this holds at any chi too.
TEMPLATE_TEST_CASE_SIG("The force of a dipole on a sphere has the right limits",
                       "[verification]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double radius       = 0.1;
  const Vector<dim> dipole  = other<dim>(3.);
  const auto force_by_field = [&](const Vector<dim> &place, const double factor) {
    const ExternalField<dim> source = dipole_source(place, dipole);
    return ball_integral<dim>(radius, [&](const Vector<dim> &x) {
      return (mu0 * factor) * (source.field_gradient(x) * source.field(x));
    });
  };

  const double chi         = 5.;
  const Vector<dim> far    = oblique<dim>(200. * radius);
  const Vector<dim> source = dipole_source(far, dipole).field({});
  const Vector<dim> moment = (sphere_volume<dim>(radius) * chi / (1. + chi / dim)) * source;
  CHECK(difference(force_of_dipole_on_sphere(chi, radius, far, dipole),
                   mu0 * (dipole_source(far, dipole).field_gradient({}) * moment)) < 1e-3);

  const Vector<dim> near = oblique<dim>(3. * radius);
  CHECK(difference(force_of_dipole_on_sphere(1e-6, radius, near, dipole),
                   force_by_field(near, 1e-6)) < 3e-6);
  if (dim == 2)
    CHECK(difference(force_of_dipole_on_sphere(chi, radius, near, dipole),
                     force_by_field(near, chi * 2. / (chi + 2.))) < 1e-6);
}

// Far apart, two spheres attract as the dipoles that the field makes of them; a sphere without
// susceptibility beside it does not change one; and each sees the other: with both exchanged the
// moments are exchanged and the force is the opposite one.
TEMPLATE_TEST_CASE_SIG("Two spheres in a field have the right limits",
                       "[verification]",
                       ((int dim), dim),
                       2,
                       3)
{
  const Vector<dim> field = other<dim>(1e5);
  const auto alone        = [&](const double radius, const double chi) {
    return (sphere_volume<dim>(radius) * chi / (1. + chi / dim)) * field;
  };

  const TwoSpheres<dim> distant = {{0.1, 0.2}, {3., 0.5}, oblique<dim>(30.)};
  const auto far                = two_spheres_in_uniform_field(distant, field);
  CHECK(difference(far.moment[1], alone(0.2, 0.5)) < 1e-3);
  const ExternalField<dim> first = dipole_source<dim>({}, alone(0.1, 3.));
  CHECK(difference(far.force_on_second,
                   mu0 * (first.field_gradient(distant.separation) * alone(0.2, 0.5))) < 1e-3);

  const TwoSpheres<dim> near = {{0.1, 0.05}, {0.91, 10.}, oblique<dim>(0.2)};
  const auto solution        = two_spheres_in_uniform_field(near, field);
  TwoSpheres<dim> exchanged  = {{0.05, 0.1}, {10., 0.91}, -1. * near.separation};
  const auto opposite        = two_spheres_in_uniform_field(exchanged, field);
  CHECK(difference(opposite.moment[0], solution.moment[1]) < 1e-10);
  CHECK(difference(opposite.force_on_second, -1. * solution.force_on_second) < 1e-7);

  exchanged.susceptibility[1] = 0.;
  const auto single           = two_spheres_in_uniform_field(exchanged, field);
  CHECK(difference(single.moment[0], alone(0.05, 10.)) < 1e-12);
  CHECK(norm(single.moment[1]) == 0.);

  const TwoSpheres<dim> overlapping = {{0.1, 0.2}, {3., 0.5}, oblique<dim>(0.25)};
  CHECK_THROWS_AS(two_spheres_in_uniform_field(overlapping, field), RunError);
}

// A sphere so small and weak that it is a dipole feels, beside a large one, the force (m.grad) H
// of the field that the large one makes alone: found once from the energy of both, once from the
// field.
TEMPLATE_TEST_CASE_SIG("The two ways to a pair force agree",
                       "[verification]",
                       ((int dim), dim),
                       2,
                       3)
{
  const double chi = 2., radius = 0.1, weak = 0.01, small = 0.01;
  const Vector<dim> field = other<dim>(1e5), place = oblique<dim>(0.3);
  const auto pair = two_spheres_in_uniform_field<dim>({{radius, small}, {chi, weak}, place}, field);
  const Vector<dim> large         = (sphere_volume<dim>(radius) * chi / (1. + chi / dim)) * field;
  const ExternalField<dim> source = dipole_source<dim>({}, large);
  const Vector<dim> moment        = (sphere_volume<dim>(small) * weak / (1. + weak / dim)) *
                             (field + source.field(place));
  CHECK(difference(pair.force_on_second, mu0 * (source.field_gradient(place) * moment)) < 5e-3);
}
