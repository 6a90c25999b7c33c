#include "catch.h"

#include <magmpm/coupling/attraction.h>

using namespace magmpm;

namespace
{
  template <int dim>
  PointAttraction<dim>
  attraction_of_exponent(const double exponent)
  {
    PointAttraction<dim> attraction;
    for (int d = 0; d < dim; ++d)
      attraction.point[d] = 0.1 * (d + 1);
    attraction.reference_distance = 0.5;
    attraction.exponent           = exponent;
    attraction.core_radius        = 0.05;
    attraction.acceleration       = 3.;
    return attraction;
  }

  /** The point of an attraction plus r along the first axis. */
  template <int dim>
  Vector<dim>
  beside(const PointAttraction<dim> &attraction, const double r)
  {
    Vector<dim> position = attraction.point;
    position[0] += r;
    return position;
  }

  template <int dim>
  Body<dim>
  body_of_two_particles()
  {
    BodyParameters<dim> parameters;
    parameters.name    = "drop";
    parameters.density = 1000.;
    MaterialParameters material;
    material.shear_modulus = 1e5;
    Body<dim> body(parameters, material);
    body.particles.resize(2);
    for (int p = 0; p < 2; ++p)
      {
        body.particles.component(ParticleProperty::mass, 0)[p] = 1. + p;
        for (int d = 0; d < dim; ++d)
          {
            body.particles.component(ParticleProperty::position, d)[p] = 0.7 + 0.2 * p - 0.4 * d;
            body.particles.component(ParticleProperty::velocity, d)[p] = 5. - d;
          }
      }
    return body;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("An attraction is g0 (r0/r)^p towards its point",
                       "[coupling]",
                       ((int dim), dim),
                       2,
                       3)
{
  // At r0 it is g0 for every p, at twice that 2^-p of it; inside the core it falls linearly from what it
  // is there; and at the point it is zero, not 0/0.
  for (const double exponent : {-1., 0., 2., 4.})
    {
      const PointAttraction<dim> attraction = attraction_of_exponent<dim>(exponent);
      CHECK(attraction.at(beside(attraction, 0.5))[0] == Approx(-3.));
      CHECK(attraction.at(beside(attraction, -0.5))[0] == Approx(3.));
      CHECK(attraction.at(beside(attraction, 1.))[0] == Approx(-3. * std::pow(2., -exponent)));
      CHECK(attraction.at(beside(attraction, 1.))[1] == 0.);
      const double at_core = attraction.at(beside(attraction, 0.05))[0];
      CHECK(at_core == Approx(-3. * std::pow(10., exponent)));
      CHECK(attraction.at(beside(attraction, 0.02))[0] == Approx(0.4 * at_core));
      CHECK(norm(attraction.at(attraction.point)) == 0.);
    }
}

TEMPLATE_TEST_CASE_SIG("An attraction gives a body exactly its force",
                       "[coupling]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The change of momentum in a step is dt sum m a(x), a named body is the only one that feels it, and
  // the largest acceleration is that of the nearest particle.
  PointAttraction<dim> attraction = attraction_of_exponent<dim>(2.);
  Body<dim> body                  = body_of_two_particles<dim>();
  const Body<dim> before          = body;
  const Vector<dim> force         = force_of(attraction, body);
  const double largest            = attract(attraction, 0.01, body);
  Vector<dim> change;
  double expected_largest = 0.;
  for (int p = 0; p < 2; ++p)
    {
      const Vector<dim> a = attraction.at(before.particles.position(p));
      expected_largest    = std::max(expected_largest, norm(a));
      change += (1. + p) * (body.particles.vector(ParticleProperty::velocity, p) -
                            before.particles.vector(ParticleProperty::velocity, p));
    }
  CHECK(largest == Approx(expected_largest));
  for (int d = 0; d < dim; ++d)
    CHECK(change[d] == Approx(0.01 * force[d]).epsilon(1e-12));
  CHECK(norm(force) > 0.);

  attraction.bodies = {"other"};
  CHECK(attract(attraction, 0.01, body) == 0.);
  CHECK(norm(force_of(attraction, body)) == 0.);
  attraction.bodies = {"other", "drop"};
  CHECK(norm(force_of(attraction, body) - force) < 0.1 * norm(force));
}
