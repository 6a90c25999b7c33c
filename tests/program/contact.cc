#include "catch.h"

#include <verification/mechanics/colliding_bodies.h>
#include <verification/mechanics/contact.h>
#include <verification/mechanics/lifted_block.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

// Rows of benchmarks/solid_verification; doc/verification.md has all of them.

TEST_CASE("A block rebounds alike wherever the ground lies on the lattice", "[program]")
{
  // Walls and bodies, on nodes and between them: 0.79 of the momentum, 0.76 on ever finer lattices. It is touched
  // where it touches, within the way of a step; nothing is gained.
  for (const Ground ground : {Ground::wall, Ground::body})
    for (const double offset : {0., 0.31})
      {
        Impact at;
        at.ground                 = ground;
        at.offset                 = offset;
        const ImpactResult result = impact(at);
        CAPTURE(static_cast<int>(ground), offset, result.first_gap, result.deepest, result.rise);
        CHECK(std::abs(result.rebound / 0.798 - 1.) < 0.0075);
        CHECK(result.first_gap <= 0.);
        CHECK(result.first_gap > -result.way - 0.02);
        CHECK(result.deepest < 0.2);
        CHECK(result.rise < 0.01);
      }
}

TEST_CASE("What an impact loses does not count its steps", "[program]")
{
  Impact at;
  const double coarse = impact(at).rebound;
  at.elastic_factor   = 0.1;
  CHECK(std::abs(impact(at).rebound / coarse - 1.) < 0.015);
}

TEST_CASE("A block slides down an incline as Coulomb's law says", "[program]")
{
  Incline incline;
  incline.offset = 0.31;
  CHECK(std::abs(slide(incline).way) < 0.01);
  incline.friction = 0.15;
  CHECK(std::abs(slide(incline).way) < 0.025);
  incline.ground = Ground::wall;
  CHECK(std::abs(slide(incline).way) < 0.025);
}

TEST_CASE("Below the angle of friction a block rests", "[program]")
{
  // mu = 0.4 > tan 0.3 = 0.309.
  Incline incline;
  incline.offset       = 0.31;
  incline.friction     = 0.4;
  incline.damping_rate = 20.;
  CHECK(std::abs(slide(incline).creep) < 0.001);
}

TEST_CASE("A cube that rolls off a ball gains no energy", "[program]")
{
  // Six cells on a ball of 3.2. With the least gap in reach of a node instead of that of the surface next to
  // it, the sum would rise by 22 % of the kinetic energy.
  CHECK(energy_rise_on(Obstruction::ball, 0.1) < 0.005);
}

TEST_CASE("Discs of two contact groups collide and part", "[program]")
{
  // Of 8 cells: 0.966 of the speed at 16 cells and 6.07 R/c of contact at 32, the rest is vibration. Momentum is kept to
  // rounding, and nothing is gained.
  Collision collision;
  collision.offset             = 0.31;
  const CollisionResult result = collide(collision);
  CHECK(result.restitution > 0.95);
  CHECK(std::abs(result.contact_time / 6.07 - 1.) < 0.025);
  CHECK(result.gap_at_end > 3.);
  CHECK(result.momentum < 1e-10);
  CHECK(result.rise < 0.01);
}

TEST_CASE("Balls of two contact groups collide and part", "[program]")
{
  // Of 4 cells: 9.05 R/c of contact at 16 cells, where Hertz has 9.80, without strains as large as these.
  Collision collision;
  collision.dim                = 3;
  collision.cells              = 4;
  collision.speed              = 0.02;
  const CollisionResult result = collide(collision);
  CHECK(result.restitution > 0.9);
  CHECK(std::abs(result.contact_time / 9.05 - 1.) < 0.05);
  CHECK(result.gap_at_end > 1.);
  CHECK(result.rise < 0.01);
}

TEST_CASE("A block slides down a slab of another contact group, and rests on it", "[program]")
{
  // As on walls and rigid bodies, by Coulomb's law; mu = 0.5 > tan 0.3 holds it.
  Incline incline;
  incline.ground = Ground::slab;
  incline.offset = 0.31;
  CHECK(std::abs(slide(incline).way) < 0.01);
  incline.friction = 0.15;
  CHECK(std::abs(slide(incline).way) < 0.025);
  incline.friction     = 0.5;
  incline.damping_rate = 2.;
  CHECK(std::abs(slide(incline).creep) < 0.001);
}

TEST_CASE("A magnet lifts a block off another of another contact group", "[program]")
{
  // With 1.1 times its weight it leaves, with 0.9 it stays; of the same group it is welded.
  CHECK(rise_of_block({1.1, 2}) > 1.);
  CHECK(std::abs(rise_of_block({0.9, 2})) < 0.05);
  CHECK(std::abs(rise_of_block({1.1, 1})) < 0.05);
}
