#include <magmpm/base/constants.h>
#include <magmpm/magnets/ring_integrals.h>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace magmpm
{
  namespace
  {
    /** Points sin^2(theta) of the midpoint rule for theta from 0 to pi/2, those below 1/2. */
    constexpr int n_pairs       = 8;
    constexpr double weight     = constants::pi / (4. * n_pairs);
    constexpr double largest_k2 = 0.75;

    std::array<double, n_pairs>
    make_points()
    {
      std::array<double, n_pairs> points;
      for (int i = 0; i < n_pairs; ++i)
        points[i] = std::pow(std::sin((i + 0.5) * weight), 2);
      return points;
    }

    const std::array<double, n_pairs> points = make_points();

    /** Boost's elliptic integrals in double precision throughout, which is several times as fast. */
    const boost::math::policies::policy<boost::math::policies::promote_double<false>> in_double;

    /**
     * What all integrals have in common: with phi = pi - 2 theta, c and s the cosine and sine of theta,
     * D^2 = D_max^2 (c^2 + kc^2 s^2) = D_max^2 (1 - k^2 s^2) and cos(phi) = s^2 - c^2.
     */
    struct Ring
    {
      double D_max, k2, kc2;

      Ring(const double radius, const double rho, const double z, const double least_distance)
      {
        const double sum = radius + rho, difference = radius - rho;
        const double D_max2 = z * z + sum * sum;
        D_max               = std::sqrt(D_max2);
        k2                  = 4. * rho * radius / D_max2;
        kc2 = std::max(z * z + difference * difference, least_distance * least_distance) / D_max2;
      }

      /** 1/Delta^2 at a point and at its mirror image at theta = pi/4. */
      std::array<double, 2>
      inverse_squares(const double point) const
      {
        return {{1. / (1. - k2 * point), 1. / (1. - k2 * (1. - point))}};
      }
    };

    /** Integrals of c^2/Delta, s^2/Delta, 1/Delta^3 over theta, Delta = sqrt(c^2 + kc^2 s^2). */
    struct EllipticIntegrals
    {
      double B, D, inverse_cube;

      explicit EllipticIntegrals(const Ring &ring)
      {
        const double K = boost::math::ellint_rf(0., ring.kc2, 1., in_double);
        D              = boost::math::ellint_rd(0., ring.kc2, 1., in_double) / 3.;
        B              = K - D;
        inverse_cube   = (B + ring.kc2 * D) / ring.kc2;
      }
    };
  } // namespace

  RingIntegrals
  ring_integrals(const double radius,
                 const double rho,
                 const double height,
                 const double least_distance)
  {
    const Ring ring(radius, rho, height, least_distance);
    const double D3 = ring.D_max * ring.D_max * ring.D_max;
    if (ring.k2 > largest_k2)
      {
        const EllipticIntegrals e(ring);
        const double C5 = e.B / ring.kc2; // s^2/Delta^3; c^2/Delta^3 is D
        return {4. / (ring.D_max * rho) * (e.D - e.B),
                4. * radius / D3 * ((radius + rho) * e.D + (radius - rho) * C5),
                4. * radius / (D3 * rho) * (C5 - e.D)};
      }
    // 1/Delta at a point less 1/Delta at its image, by k^2 and the sine that both have in common.
    double difference1 = 0., difference3 = 0., sum3 = 0.;
    for (const double point : points)
      {
        const auto squares = ring.inverse_squares(point);
        const double near = std::sqrt(squares[1]), far = std::sqrt(squares[0]);
        const double cosine = 1. - 2. * point; // c^2 - s^2
        // 1/near - 1/far, each squared, is k^2 (c^2 - s^2).
        const double slope = cosine * squares[0] * squares[1] / (near + far);
        difference1 += cosine * slope;
        difference3 += cosine * slope * (squares[0] + squares[1] + near * far);
        sum3 += squares[0] * far + squares[1] * near;
      }
    const double k2_over_rho = 4. * radius / (ring.D_max * ring.D_max);
    const double cosines3    = k2_over_rho * weight * difference3; // of cos(phi)/Delta^3, over rho
    return {4. / ring.D_max * k2_over_rho * weight * difference1,
            4. * radius / D3 * (radius * weight * sum3 - rho * rho * cosines3),
            4. * radius / D3 * cosines3};
  }

  RingDerivatives
  ring_derivatives(const double radius,
                   const double rho,
                   const double height,
                   const double least_distance)
  {
    const Ring ring(radius, rho, height, least_distance);
    const double D2 = ring.D_max * ring.D_max, D5 = D2 * D2 * ring.D_max;
    double ones5, cosines5, cosines3; // integrals of 1/Delta^5, cos(phi)/Delta^5, cos(phi)/Delta^3
    if (ring.k2 > largest_k2)
      {
        const EllipticIntegrals e(ring);
        const double E     = e.B + ring.kc2 * e.D;
        const double K     = e.B + e.D;
        ones5              = (2. * (1. + ring.kc2) * E - ring.kc2 * K) / (3. * ring.kc2 * ring.kc2);
        const double sines = (ones5 - e.inverse_cube) / ring.k2;
        cosines5           = 2. * sines - ones5;
        cosines3           = e.B / ring.kc2 - e.D;
      }
    else
      {
        double sum5 = 0., difference5 = 0., difference3 = 0.;
        for (const double point : points)
          {
            const auto squares  = ring.inverse_squares(point);
            const double cosine = 1. - 2. * point;
            const double far    = squares[0] * std::sqrt(squares[0]),
                         near   = squares[1] * std::sqrt(squares[1]);
            sum5 += far * squares[0] + near * squares[1];
            difference3 += cosine * (near - far);
            difference5 += cosine * (near * squares[1] - far * squares[0]);
          }
        ones5    = weight * sum5;
        cosines5 = weight * difference5;
        cosines3 = weight * difference3;
      }
    const double z = height;
    return {-12. * z * radius / D5 * (radius * ones5 - rho * cosines5),
            4. * radius / (D2 * ring.D_max) * cosines3 - 12. * z * z * radius / D5 * cosines5};
  }

  RimIntegrals
  rim_integrals(const double radius,
                const double rho,
                const double height,
                const double least_distance)
  {
    const Ring ring(radius, rho, height, least_distance);
    // s^2 = (R + rho)^2 (1 - m sin^2), where 1 - m = g^2.
    const double sum = radius + rho, g = (radius - rho) / sum, m = 4. * rho * radius / (sum * sum);
    const double angle_factor  = 4. * radius / (sum * ring.D_max);
    const double across_factor = 16. / (sum * sum * ring.D_max);
    if (m > largest_k2)
      {
        const double K = boost::math::ellint_rf(0., ring.kc2, 1., in_double);
        const double D = boost::math::ellint_rd(0., ring.kc2, 1., in_double) / 3.;
        if (g == 0.)
          return {angle_factor * K, across_factor / m * D};
        const double J = boost::math::ellint_rj(0., ring.kc2, 1., g * g, in_double) / 3.;
        return {angle_factor * (K + (g - g * g) * J), across_factor / m * (D - g * g * J)};
      }
    double angle = 0., across = 0.;
    for (const double point : points)
      {
        const auto squares = ring.inverse_squares(point);
        const double far   = std::sqrt(squares[0]) / (1. - m * point),
                     near  = std::sqrt(squares[1]) / (1. - m * (1. - point));
        angle += (1. - point * (1. - g)) * far + (point + g * (1. - point)) * near;
        across += point * (1. - point) * (far + near);
      }
    return {angle_factor * weight * angle, across_factor * weight * across};
  }
} // namespace magmpm
