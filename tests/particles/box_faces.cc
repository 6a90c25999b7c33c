#include <magmpm/particles/box_faces.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** One particle per face that a step took 0.2 dx through it, or further, and one in the middle. */
  template <int dim>
  std::vector<Body<dim>>
  particles_beyond_faces(const Lattice<dim> &lattice,
                         const MechanicalLaw law,
                         const double depth,
                         BlockSet<dim> &blocks)
  {
    std::vector<Body<dim>> bodies;
    bodies.push_back(empty_body<dim>(law, false));
    Random random(5);
    add_random_particles(lattice, 7., 9., 2 * dim + 1, random, bodies[0]);
    ParticleSet<dim> &particles = bodies[0].particles;
    for (int face = 0; face < 2 * dim; ++face)
      {
        const int d                  = face / 2;
        const double dx              = lattice.spacing;
        particles.component(ParticleProperty::position,
                            d)[face] = (face % 2 == 0 ? lattice.lower_corner[d] + 0.1 * dx
                                                      : lattice.upper_corner()[d] - 0.1 * dx);
        particles.component(ParticleProperty::velocity, d)[face] = (face % 2 == 0 ? -3. : 3.);
      }
    blocks = active_blocks(bodies, lattice);
    sort_all(blocks, lattice, bodies);
    for (std::size_t p = 0; p < particles.size(); ++p)
      for (int d = 0; d < dim; ++d)
        particles.component(ParticleProperty::position,
                            d)[p] += (0.1 + depth) / 3. * lattice.spacing *
                                     particles.component(ParticleProperty::velocity, d)[p];
    return bodies;
  }

  template <int dim>
  std::size_t
  place_of(const Body<dim> &body, const std::uint64_t id)
  {
    const auto &ids = body.particles.ids();
    return std::find(ids.begin(), ids.end(), id) - ids.begin();
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("walls hold particles, and take the momentum that goes into them",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A particle beyond each face: it comes back onto the face, loses the velocity through it and
  // keeps the one along it; the particle in the middle keeps all. Held again, nothing happens. A
  // face that is open lets its particle go. Particles of solids may lie half a cell behind it.
  const Lattice<dim> lattice = test_lattice<dim>();
  for (const MechanicalLaw law : {MechanicalLaw::viscoelastic_fluid, MechanicalLaw::neo_hookean})
    for (const int open_face : {-1, 0, 2 * dim - 1})
      {
        const bool is_solid = (law == MechanicalLaw::neo_hookean);
        const double behind = is_solid ? 0.5 * lattice.spacing : 0.;
        BlockSet<dim> blocks;
        if (is_solid)
          {
            auto shallow = particles_beyond_faces(lattice, law, 0.45, blocks);
            CHECK(hold_at_walls(blocks, lattice, {}, shallow[0]) == 0);
          }
        std::vector<Body<dim>> bodies =
          particles_beyond_faces(lattice, law, is_solid ? 0.7 : 0.2, blocks);
        Body<dim> &body        = bodies[0];
        const Body<dim> before = body;
        OpenFaces<dim> open    = {};
        if (open_face >= 0)
          open[open_face] = true;
        CHECK(hold_at_walls(blocks, lattice, open, body) ==
              (open_face < 0 ? 2 * dim : 2 * dim - 1));
        CHECK(hold_at_walls(blocks, lattice, open, body) == 0);
        for (int id = 0; id < 2 * dim + 1; ++id)
          {
            const std::size_t p   = place_of(body, id);
            Vector<dim> position  = before.particles.position(p);
            Vector<dim> velocity  = before.particles.vector(ParticleProperty::velocity, p);
            const bool is_through = (id < 2 * dim && id != open_face);
            if (is_through)
              {
                const int d = id / 2;
                position[d] = (id % 2 == 0 ? lattice.lower_corner[d] - behind
                                           : lattice.upper_corner()[d] + behind);
                velocity[d] = 0.;
              }
            CHECK(norm(body.particles.position(p) - position) == 0.);
            CHECK(norm(body.particles.vector(ParticleProperty::velocity, p) - velocity) == 0.);
          }
      }
}

TEST_CASE("particles outside of the box are removed and described", "[particles]")
{
  // Two of six particles are outside, one of them beyond the last face. The others stay as they were. One of a
  // solid half a cell behind a wall is not outside, but it is if the face is open.
  const Lattice<2> lattice = test_lattice<2>();
  Body<2> body             = empty_body<2>(MechanicalLaw::viscoelastic_fluid, false);
  Random random(3);
  add_random_particles(lattice, 4., 8., 6, random, body);
  body.particles.component(ParticleProperty::position, 0)[1] = lattice.lower_corner[0] - 0.01;
  body.particles.component(ParticleProperty::position, 1)[4] = lattice.upper_corner()[1] + 0.01;
  const Body<2> before                                       = body;
  const std::vector<Departure<2>> departed                   = remove_departed(lattice, {}, body);
  REQUIRE(departed.size() == 2);
  CHECK(departed[0].id == 1);
  CHECK(departed[0].face == 0);
  CHECK(departed[1].id == 4);
  CHECK(departed[1].face == 3);
  CHECK(norm(departed[1].position - before.particles.position(4)) == 0.);
  CHECK(norm(departed[1].velocity - before.particles.vector(ParticleProperty::velocity, 4)) == 0.);
  CHECK(body.particles.ids() == std::vector<std::uint64_t>{0, 2, 3, 5});
  CHECK(norm(body.particles.position(2) - before.particles.position(3)) == 0.);
  CHECK(remove_departed(lattice, {}, body).empty());

  Body<2> solid = empty_body<2>(MechanicalLaw::neo_hookean, false);
  add_random_particles(lattice, 4., 8., 6, random, solid);
  solid.particles.component(ParticleProperty::position, 0)[1] = lattice.lower_corner[0] -
                                                                0.4 * lattice.spacing;
  CHECK(remove_departed(lattice, {}, solid).empty());
  CHECK(remove_departed(lattice, {true, false, false, false}, solid).size() == 1);
}
