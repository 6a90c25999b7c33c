#include <magmpm/base/constants.h>
#include <magmpm/boundary/fluid_contact.h>
#include <magmpm/boundary/rigid_collision.h>
#include <magmpm/lattice/node_window.h>

#include "catch.h"
#include "cube_of_blocks.h"

#include <algorithm>
#include <random>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  /** The box has 16 cells along its edges. */
  template <int dim>
  Lattice<dim>
  test_lattice()
  {
    return cube_lattice<dim>(16, 0.1);
  }

  template <int dim>
  BlockSet<dim>
  all_blocks()
  {
    return blocks_of_cube<dim>(16);
  }

  template <int dim>
  Vector<dim>
  filled(const double value)
  {
    Vector<dim> result;
    for (int d = 0; d < dim; ++d)
      result[d] = value;
    return result;
  }

  template <int dim>
  RigidBody<dim>
  free_ball(const Vector<dim> &centre,
            const double radius,
            const double mass,
            const SurfaceContact &contact)
  {
    ShapeParameters<dim> parameters;
    parameters.type   = ShapeType::sphere;
    parameters.centre = centre;
    parameters.radius = radius;
    RigidBody<dim> body("ball", make_shape(parameters), contact);
    body.set_free(mass);
    return body;
  }

  /** Nodes of random mass and velocity everywhere but on the walls. */
  template <int dim>
  NodeField<dim>
  random_nodes(const BlockSet<dim> &blocks)
  {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> number(-1., 1.);
    NodeField<dim> field;
    field.reinit(blocks.size());
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          for (int d = 0; d < dim; ++d)
            field.node(slot, n)[d] = number(generator);
          field.node(slot, n)[3] = 1.1 + number(generator);
        }
    return field;
  }

  /** Momenta, then angular momenta about the origin, then twice the kinetic energy. */
  template <int dim>
  std::pair<RigidVector<dim>, double>
  momentum_and_energy(const BlockSet<dim> &blocks,
                      const std::vector<RigidBody<dim>> &bodies,
                      const NodeField<dim> &field)
  {
    RigidVector<dim> momentum;
    double energy = 0.;
    for (const RigidBody<dim> &body : bodies)
      {
        momentum += momentum_of<dim>(body.mass() * body.motion().velocity, body.pose().position);
        momentum += rigid_vector<dim>({}, body.angular_momentum());
        energy += 2. * body.kinetic_energy();
      }
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          Vector<dim> velocity;
          std::copy_n(field.node(slot, n), dim, velocity.values);
          const double mass = field.node(slot, n)[3];
          momentum += momentum_of<dim>(
            mass * velocity,
            test_lattice<dim>().node_position(node_of_block<dim>(blocks.block(slot), n)));
          energy += mass * norm_square(velocity);
        }
    return {momentum, energy};
  }

  /** Bodies and fluid on all nodes, in a box without walls. @return the number of sweeps. */
  template <int dim>
  int
  collide_with_fluid(const BlockSet<dim> &blocks,
                     std::vector<RigidBody<dim>> &bodies,
                     NodeField<dim> &field)
  {
    const WallParameters<dim> walls = all_walls<dim>(WallCondition::open);
    const SolidContact<dim> no_solids(test_lattice<dim>(), walls, bodies);
    FluidContact<dim> contact(find_fluid_constraints(
      bodies, no_solids, walls, blocks, test_lattice<dim>(), 1e-12, field, MPI_COMM_SELF));
    const int n_sweeps = contact.solve(bodies);
    NodeField<dim> not_wanted;
    contact.apply(blocks, LatticeBoundary<dim>(test_lattice<dim>(), walls), field, not_wanted);
    return n_sweeps;
  }
} // namespace

namespace
{
  /** What contact leaves to be done, over what it did: velocities of nodes. */
  template <int dim>
  double
  left_to_do(const ContactCondition condition, const double mass)
  {
    // Nodes of random velocity in and around two spinning balls, one of which weighs as much as the nodes in it.
    // Whatever the contact takes away goes from one to the other: both sums are kept to rounding. Energy may only
    // be lost.
    const BlockSet<dim> blocks   = all_blocks<dim>();
    const SurfaceContact contact = {condition, condition == ContactCondition::stick ? 0. : 0.3};
    std::vector<RigidBody<dim>> bodies = {free_ball<dim>(filled<dim>(0.52), 0.23, mass, contact),
                                          free_ball<dim>(filled<dim>(1.08), 0.31, 1e2, contact)};
    bodies[0].set_motion({filled<dim>(0.5), {{3.}}});
    bodies[1].set_motion({filled<dim>(-0.2), {{-1.}}});
    // Particles of a fluid are outside: nodes inside have little mass.
    NodeField<dim> field = random_nodes<dim>(blocks);
    for_nodes(blocks, [&](const int slot, const int n) {
      const Vector<dim> position =
        test_lattice<dim>().node_position(node_of_block<dim>(blocks.block(slot), n));
      for (const RigidBody<dim> &body : bodies)
        if (body.surface_distance(position).distance < 0.)
          field.node(slot, n)[3] *= 0.1;
    });
    const NodeField<dim> before_field = field;
    const auto before                 = momentum_and_energy(blocks, bodies, field);
    const int n_sweeps                = collide_with_fluid(blocks, bodies, field);
    const auto after                  = momentum_and_energy(blocks, bodies, field);
    CAPTURE(static_cast<int>(condition), mass, before.second, after.second, n_sweeps);
    CHECK(norm(after.first - before.first) < 1e-12 * (norm(before.first) + before.second));
    CHECK(after.second < before.second * (1. + 1e-14));
    CHECK(after.second < 0.999999 * before.second + 1e-4 * mass);

    // Once more.
    const NodeField<dim> first = field;
    collide_with_fluid(blocks, bodies, field);
    double change = 0., pushed = 0.;
    for_nodes(blocks, [&](const int slot, const int n) {
      const auto velocity = [&](const NodeField<dim> &of) {
        return of.get(NodeMotion::velocity, slot, n);
      };
      change = std::max(change, norm(velocity(field) - velocity(first)));
      pushed = std::max(pushed, norm(velocity(first) - velocity(before_field)));
    });
    CHECK(pushed > 0.1);
    return change / pushed;
  }

  constexpr auto all_conditions = {ContactCondition::stick,
                                   ContactCondition::slip,
                                   ContactCondition::separate};
} // namespace

TEMPLATE_TEST_CASE_SIG("an impact of bodies and nodes conserves momentum and angular momentum",
                       "[boundary]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The masses of bodies and nodes in any ratio; once more changes nothing, but where the body is much lighter than
  // the nodes that it touches, see the next test.
  for (const ContactCondition condition : all_conditions)
    {
      for (const double mass : {1e2, 1e8})
        CHECK(left_to_do<dim>(condition, mass) < 1e-5);
      for (const double mass : {1e-6, 0.1})
        CHECK(left_to_do<dim>(condition, mass) < 0.05);
    }
}

TEST_CASE("an impact of a light body leaves nothing to do", "[boundary][!shouldfail]")
{
  // A limit that is missed: as of heavy ones. A light body comes to rest among the nodes slowly. Whoever mends that is
  // told so by this test.
  for (const double mass : {1e-6, 0.1})
    CHECK(left_to_do<2>(ContactCondition::stick, mass) < 1e-5);
}

TEST_CASE("a light body takes over the motion of the material around it", "[boundary]")
{
  // Nodes that move rigidly, all with the same velocity and spin, and a body of next to no mass within, at rest:
  // it gets their motion, and they keep it. One of a great mass stays.
  const BlockSet<2> blocks = all_blocks<2>();
  const Vector<2> centre   = {{0.8, 0.8}};
  for (const double mass : {1e-6, 1e6})
    {
      NodeField<2> field(blocks.size());
      for_nodes(blocks, [&](const int slot, const int n) {
        const Vector<2> arm =
          test_lattice<2>().node_position(node_of_block<2>(blocks.block(slot), n)) - centre;
        field.set(
          NodeMotion::velocity, slot, n, Vector<2>{{1., 2.}} + rotation_velocity<2>({{5.}}, arm));
        field.set(NodeMotion::mass, slot, n, 0.1);
      });
      std::vector<RigidBody<2>> bodies = {
        free_ball<2>(centre, 0.35, mass, {ContactCondition::stick, 0.})};
      collide_with_fluid(blocks, bodies, field);
      const double share = (mass < 1. ? 1. : 0.);
      CHECK(bodies[0].motion().velocity[0] == Approx(share).margin(1e-4));
      CHECK(bodies[0].motion().velocity[1] == Approx(2. * share).margin(1e-4));
      CHECK(bodies[0].motion().angular_velocity[0] == Approx(5. * share).margin(1e-4));
    }
}

namespace
{
  /** Bodies among themselves and within walls, without material. */
  template <int dim>
  struct Arena
  {
    Arena(const std::vector<RigidBody<dim>> &bodies_at_start,
          const WallCondition condition,
          const double friction_of_walls = 0.)
      : bodies(bodies_at_start)
      , walls(all_walls<dim>(condition, friction_of_walls))
      , boundary(test_lattice<dim>(), walls)
      , no_contact(test_lattice<dim>(), walls, bodies)
      , collision(test_lattice<dim>(), walls, bodies, 0.05)
    {
    }

    void
    step(const double time_step, const std::vector<Vector<dim>> &accelerations)
    {
      for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].is_free())
          bodies[b].add_impulse((time_step * bodies[b].mass()) * accelerations[b], {});
      collision.collide(
        blocks, boundary, time_step, MPI_COMM_SELF, {{no_contact, field, not_wanted}}, bodies);
      for (RigidBody<dim> &body : bodies)
        if (body.is_free())
          body.advance(time_step);
    }

    std::vector<RigidBody<dim>> bodies;
    const WallParameters<dim> walls;
    const BlockSet<dim> blocks;
    NodeField<dim> field, not_wanted;
    const LatticeBoundary<dim> boundary;
    const SolidContact<dim> no_contact;
    const RigidCollision<dim> collision;
  };

  template <int dim>
  RigidBody<dim>
  free_box(const Vector<dim> &lower, const Vector<dim> &upper, const double friction)
  {
    ShapeParameters<dim> parameters;
    parameters.lower_corner = lower;
    parameters.upper_corner = upper;
    RigidBody<dim> body("box", make_shape(parameters), {ContactCondition::slip, friction});
    body.set_free(2.);
    return body;
  }
} // namespace

TEST_CASE("a falling body comes to rest on a wall", "[boundary]")
{
  // A box falls by 0.5 m onto the floor, restitution 0. It lies there without motion, neither above
  // the floor nor deeper in it than a hundredth of a cell.
  Arena<3> arena({free_box<3>({{0.5, 0.5, 0.5}}, {{0.9, 0.8, 0.7}}, 0.)}, WallCondition::slip);
  for (int step = 0; step < 1000; ++step)
    arena.step(1e-3, {{{0., 0., -10.}}});
  const RigidBody<3> &box = arena.bodies[0];
  CHECK(box.pose().position[2] < 0.1 + 1e-6);
  CHECK(box.pose().position[2] > 0.1 - 0.001 - 1e-9);
  CHECK(box.max_speed() < 1e-6);
  CHECK(frobenius_norm(box.pose().rotation + (-1.) * identity<3>()) < 1e-6);
}

TEST_CASE("friction stops a sliding body after v^2/(2 mu g)", "[boundary]")
{
  // A box slides on the floor at 1 m/s with a coefficient of 0.5: Coulomb's law stops it after 0.1 m;
  // without friction it goes on. It is flat, so that it does not tip over. The larger of its coefficient and that
  // of the wall counts.
  const auto way = [](const double friction, const double of_wall, const double time) {
    Arena<2> arena(
      {free_box<2>({{0.2, 0.}}, {{0.6, 0.1}}, friction)}, WallCondition::slip, of_wall);
    arena.bodies[0].set_motion({{{1., 0.}}, {}});
    for (double t = 0.; t < time; t += 1e-3)
      arena.step(1e-3, {{{0., -10.}}});
    return arena.bodies[0].pose().position[0] - 0.4;
  };
  CHECK(way(0.5, 0., 0.5) == Approx(0.1).epsilon(0.01));
  CHECK(way(0.2, 0.5, 0.5) == Approx(0.1).epsilon(0.01));
  CHECK(way(0., 0., 0.5) == Approx(0.5).epsilon(0.01));
}

TEST_CASE("two equal bodies pulled together come to rest in contact", "[boundary]")
{
  // Two balls pulled to each other by equal forces, off the axes of the lattice. Their momentum stays
  // zero to rounding, they touch and stay: centres two radii apart but for the facets of the sampled
  // surface, spacing^2/(8 R) = 2e-3 m, and the tolerated overlap of 1e-3 m.
  const Vector<3> pull = {{6., 4., 3.}};
  const Vector<3> half = (0.4 / norm(pull)) * pull, middle = {{0.8, 0.8, 0.8}};
  const SurfaceContact contact = {ContactCondition::separate, 0.2};
  Arena<3> arena({free_ball<3>(middle - half, 0.15, 2., contact),
                  free_ball<3>(middle + half, 0.15, 2., contact)},
                 WallCondition::open);
  double fastest = 0.;
  for (int step = 0; step < 1000; ++step)
    {
      arena.step(1e-3, {pull, (-1.) * pull});
      fastest = std::max(fastest, norm(arena.bodies[0].motion().velocity));
    }
  const RigidBody<3> &one = arena.bodies[0], &other = arena.bodies[1];
  CHECK(fastest > 1.9);
  CHECK(norm(one.motion().velocity + other.motion().velocity) < 1e-12);
  CHECK(norm(other.pose().position - one.pose().position) > 0.3 - 4e-3);
  CHECK(norm(other.pose().position - one.pose().position) < 0.3 + 1e-3);
  CHECK(norm(other.motion().velocity) < 1e-2);
}
