#include <magmpm/boundary/momentum_update.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  Lattice<2>
  test_lattice()
  {
    Lattice<2> lattice;
    lattice.spacing = 0.1;
    lattice.n_cells = {8, 8};
    return lattice;
  }

  /** The velocity and mass of one node after the update, with sticking walls and gravity -10. */
  std::array<double, n_lanes>
  updated(const Index<2> &node,
          const std::array<double, n_lanes> &momentum_and_mass,
          const double damping_rate = 0.)
  {
    const BlockSet<2> blocks({{0, 0}, {1, 0}}, 1); // the second is a ghost
    const std::vector<RigidBody<2>> no_bodies;
    const LatticeBoundary<2> boundary(test_lattice(), WallParameters<2>());
    NodeField<2> field;
    field.reinit(blocks.size());
    double *lanes = field.node(blocks.slot(block_of<2>(node)), (node[0] & 3) + 4 * (node[1] & 3));
    std::copy(momentum_and_mass.begin(), momentum_and_mass.end(), lanes);
    NodeField<2> not_wanted;
    SolidContact<2> no_contact(test_lattice(), WallParameters<2>(), no_bodies);
    update_lattice_momentum(
      blocks, boundary, no_contact, {{0., -10.}}, 0.01, damping_rate, 1., field, not_wanted);
    return {lanes[0], lanes[1], lanes[2], lanes[3]};
  }
} // namespace

TEST_CASE("momentum becomes velocity, with gravity and walls", "[boundary]")
{
  // A node inside with mass 2: v = p/m + dt g. On a wall that sticks the velocity is zero, and the
  // mass stays what it was on both.
  const auto inside = updated({1, 2}, {4., 6., 0., 2.});
  CHECK(inside[0] == Approx(2.));
  CHECK(inside[1] == Approx(3. - 0.1));
  CHECK(inside[3] == 2.);
  CHECK(updated({0, 2}, {4., 6., 0., 2.}) == std::array<double, n_lanes>{0., 0., 0., 2.});
}

TEST_CASE("damping takes its part of the velocity", "[boundary]")
{
  // dv/dt = -rate v over a step is a factor of exp(-rate dt), on what gravity gave in it too.
  const auto damped = updated({1, 2}, {4., 6., 0., 2.}, 30.);
  CHECK(damped[0] == Approx(2. * std::exp(-0.3)));
  CHECK(damped[1] == Approx(2.9 * std::exp(-0.3)));
  CHECK(damped[3] == 2.);
}

TEST_CASE("nodes with next to no mass rest, others are divided by what they have", "[boundary]")
{
  // 1e-12 of the mass of a particle is the documented limit, on both sides of it, and no mass at
  // all. p/m of what is left of rounding would be any number.
  const auto light = updated({1, 2}, {2e-11, 0., 0., 1e-11});
  CHECK(light[0] == Approx(2.));
  CHECK(light[1] == Approx(-0.1));
  CHECK(updated({1, 2}, {1., 1., 0., 1e-13}) == std::array<double, n_lanes>{0., 0., 0., 1e-13});
  CHECK(updated({1, 2}, {0., 0., 0., 0.}) == std::array<double, n_lanes>{});
}

TEST_CASE("ghosts are left to their owner", "[boundary]")
{
  // A node of a ghost block keeps its momentum: its velocity comes from its owner afterwards.
  const std::array<double, n_lanes> momentum_and_mass = {4., 6., 0., 2.};
  CHECK(updated({5, 2}, momentum_and_mass) == momentum_and_mass);
}
