#include <magmpm/coupling/rigid_hold.h>
#include <magmpm/geometry/sphere_shape.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  template <int dim>
  double
  depth(const Body<dim> &body, const std::size_t p, const Vector<dim> &centre, const double radius)
  {
    return radius - norm(body.particles.position(p) - centre);
  }
} // namespace

TEMPLATE_TEST_CASE_SIG(
  "particles deep inside a rigid shape are put back, and their momentum counted",
  "[coupling]",
  ((int dim), dim),
  2,
  3)
{
  // Random particles, and a ball that moves through their middle. Those deeper than the tolerated depth
  // come up by a tenth of dx, or to that depth if that is nearer, and go no further in relative to the
  // ball; all others stay as they are. What they lost is the impulse, to rounding; called again and again,
  // none is left too deep.
  const Lattice<dim> lattice = test_lattice<dim>();
  std::vector<Body<dim>> bodies;
  bodies.push_back(empty_body<dim>(MechanicalLaw::neo_hookean, false));
  Random random(5);
  add_random_particles(lattice, 5., 9., 400, random, bodies[0]);
  const BlockSet<dim> blocks = active_blocks(bodies, lattice);
  sort_all(blocks, lattice, bodies);
  Body<dim> &body = bodies[0];

  Vector<dim> centre = lattice.lower_corner;
  for (int d = 0; d < dim; ++d)
    centre[d] += 7. * lattice.spacing;
  const double radius = 2. * lattice.spacing, tolerated = 0.5 * lattice.spacing;
  const SphereShape<dim> ball({}, radius);
  RigidMotion<dim> motion;
  motion.velocity[0] = 0.2;

  const Body<dim> before = body;
  const RigidHold<dim> hold =
    hold_outside<dim>(blocks, lattice, ball, {centre, identity<dim>()}, motion, tolerated, body);
  std::size_t n_inside = 0, n_held = 0;
  double deepest = 0.;
  Vector<dim> impulse;
  for (std::size_t p = 0; p < body.particles.size(); ++p)
    {
      const double was = depth(before, p, centre, radius), is = depth(body, p, centre, radius);
      const Vector<dim> velocity = body.particles.vector(ParticleProperty::velocity, p);
      const Vector<dim> change = velocity - before.particles.vector(ParticleProperty::velocity, p);
      n_inside += (was > 0.);
      n_held += (was > tolerated);
      deepest = std::max(deepest, was);
      impulse -= body.particles.component(ParticleProperty::mass, 0)[p] * change;
      if (was <= tolerated)
        {
          CHECK(is == was);
          CHECK(norm(change) == 0.);
          continue;
        }
      CHECK(is == Approx(std::max(tolerated, was - 0.1 * lattice.spacing)));
      const Vector<dim> outward = before.particles.position(p) - centre;
      CHECK(dot(velocity - motion.velocity, outward) > -1e-12 * norm(outward));
    }
  CHECK(n_held > 10);
  CHECK(hold.n_inside == n_inside);
  CHECK(hold.n_held == n_held);
  CHECK(hold.deepest == Approx(deepest));
  CHECK(norm(hold.impulse - impulse) < 1e-12 * (1. + norm(impulse)));

  for (int step = 0; step < 20; ++step)
    hold_outside<dim>(blocks, lattice, ball, {centre, identity<dim>()}, motion, tolerated, body);
  for (std::size_t p = 0; p < body.particles.size(); ++p)
    CHECK(depth(body, p, centre, radius) < tolerated * (1. + 1e-9));
}
