#include <magmpm/boundary/lattice_boundary.h>
#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/motion/expression.h>
#include <magmpm/motion/pose_function.h>

#include "catch.h"

using namespace magmpm;

namespace
{
  constexpr int edge = 8; ///< of the box in cells

  template <int dim>
  Lattice<dim>
  test_lattice()
  {
    Lattice<dim> lattice;
    lattice.spacing = 0.25;
    for (int d = 0; d < dim; ++d)
      {
        lattice.lower_corner[d] = -1. + 0.5 * d;
        lattice.n_cells[d]      = edge;
      }
    return lattice;
  }

  template <int dim>
  WallParameters<dim>
  all_walls(const WallCondition condition)
  {
    WallParameters<dim> walls;
    walls.condition.fill(condition);
    return walls;
  }

  template <int dim>
  Vector<dim>
  some_velocity(const double sign = 1.)
  {
    Vector<dim> velocity;
    for (int d = 0; d < dim; ++d)
      velocity[d] = sign * (1.5 + 0.5 * d);
    return velocity;
  }

  template <int dim>
  Index<dim>
  middle_node()
  {
    Index<dim> node;
    node.fill(edge / 2);
    return node;
  }

  /** A node in the middle of a face, @p beyond nodes outside. */
  template <int dim>
  Index<dim>
  node_on_face(const int face, const int beyond)
  {
    Index<dim> node = middle_node<dim>();
    node[face / 2]  = (face % 2 == 0 ? -beyond : edge + beyond);
    return node;
  }

  /** A ball in the middle of the box, such as a solid magnet is. */
  template <int dim>
  MovedBody<dim>
  ball(const ContactCondition contact, const std::string &position, const double radius = 0.7)
  {
    RigidBodyProperties<dim> properties;
    properties.contact.condition = contact;
    const std::shared_ptr<const Shape<dim>> shape =
      std::make_shared<SphereShape<dim>>(Vector<dim>(), radius);
    MovedBody<dim> ball = {make_rigid_body("ball", shape, properties),
                           pose_function(read_expression<dim>(position, "ball")),
                           MovedBody<dim>::Frame::shape,
                           {}};
    return ball;
  }

  template <int dim>
  std::string
  middle(const std::string &in_plane = "0; 0.5")
  {
    return in_plane + (dim == 3 ? "; 1" : "");
  }

  template <int dim>
  void
  check_velocity(const Vector<dim> &velocity, const Vector<dim> &expected)
  {
    for (int d = 0; d < dim; ++d)
      CHECK(velocity[d] == Approx(expected[d]).margin(1e-14));
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("walls hold the nodes on and beyond them, each face by its condition",
                       "[boundary]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A velocity into each face and its opposite, at a node on the face and one beyond. Stick leaves
  // nothing, slip the tangential part, separate what does not go into the wall: exact numbers.
  const std::vector<RigidBody<dim>> no_bodies;
  for (const int face : {0, 1, 2, 3, 4, 5})
    for (const int beyond : {0, 1, 3})
      {
        if (face / 2 >= dim)
          continue;
        const Index<dim> node = node_on_face<dim>(face, beyond);
        const double inwards  = (face % 2 == 0 ? 1. : -1.);
        const Vector<dim> in = some_velocity<dim>(inwards), out = some_velocity<dim>(-inwards);
        const auto without_normal = [face](Vector<dim> velocity) {
          velocity[face / 2] = 0.;
          return velocity;
        };
        // The other faces are of another kind, and must not matter here.
        const auto with = [&](const WallCondition condition, const WallCondition others) {
          WallParameters<dim> walls = all_walls<dim>(others);
          walls.condition[face]     = condition;
          return LatticeBoundary<dim>(test_lattice<dim>(), walls, no_bodies);
        };
        const LatticeBoundary<dim> stick = with(WallCondition::stick, WallCondition::slip);
        check_velocity(stick.constrained(node, in), {});
        check_velocity(stick.constrained(node, out), {});
        const LatticeBoundary<dim> slip = with(WallCondition::slip, WallCondition::stick);
        check_velocity(slip.constrained(node, in), without_normal(in));
        check_velocity(slip.constrained(node, out), without_normal(out));
        const LatticeBoundary<dim> separate = with(WallCondition::separate, WallCondition::stick);
        check_velocity(separate.constrained(node, in), in);
        check_velocity(separate.constrained(node, out), without_normal(out));
      }
}

TEMPLATE_TEST_CASE_SIG("walls do not touch the nodes inside", "[boundary]", ((int dim), dim), 2, 3)
{
  // The first nodes inside of each face, and the middle one, keep their velocity although all walls
  // stick. What holds particles back from the wall is the velocity of the nodes on it.
  const std::vector<RigidBody<dim>> no_bodies;
  const LatticeBoundary<dim> boundary(
    test_lattice<dim>(), all_walls<dim>(WallCondition::stick), no_bodies);
  check_velocity(boundary.constrained(middle_node<dim>(), some_velocity<dim>()),
                 some_velocity<dim>());
  for (int face = 0; face < 2 * dim; ++face)
    check_velocity(boundary.constrained(node_on_face<dim>(face, -1), some_velocity<dim>()),
                   some_velocity<dim>());
  CHECK(boundary.max_speed() == 0.);
}

TEST_CASE("a node in a corner obeys all walls that meet there", "[boundary]")
{
  // Walls along x slip, along y separate, along z stick; the corners where two of them meet. Each
  // condition is applied to what the others leave, so an edge between slip and separate keeps what is
  // tangential to both, and an edge with a sticking wall nothing.
  WallParameters<3> walls;
  walls.condition = {WallCondition::slip,
                     WallCondition::slip,
                     WallCondition::separate,
                     WallCondition::separate,
                     WallCondition::stick,
                     WallCondition::stick};
  const std::vector<RigidBody<3>> no_bodies;
  const LatticeBoundary<3> boundary(test_lattice<3>(), walls, no_bodies);
  check_velocity<3>(boundary.constrained({0, 0, 4}, {{-1., -2., -3.}}), {{0., 0., -3.}});
  check_velocity<3>(boundary.constrained({0, 0, 4}, {{-1., 2., -3.}}), {{0., 2., -3.}});
  check_velocity<3>(boundary.constrained({edge, edge, 4}, {{1., 2., 3.}}), {{0., 0., 3.}});
  check_velocity<3>(boundary.constrained({edge, edge, 4}, {{1., -2., 3.}}), {{0., -2., 3.}});
  check_velocity<3>(boundary.constrained({4, 0, 0}, {{-1., 2., 3.}}), {});
  check_velocity<3>(boundary.constrained({-1, -1, edge + 1}, {{1., 2., 3.}}), {});
}

TEMPLATE_TEST_CASE_SIG("a solid magnet holds the nodes inside it",
                       "[boundary]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A ball at rest around the middle node (0, 1/2, 1), and a node 0.5 m beside it along x: outward is
  // +x. Into the ball and out of it stick, slip and separate leave what they leave at a wall; a magnet
  // without a surface leaves everything.
  Index<dim> node = middle_node<dim>();
  node[0] += 2;
  const Vector<dim> out = some_velocity<dim>(), in = some_velocity<dim>(-1.);
  const auto constrained = [&](const ContactCondition contact, const Vector<dim> &velocity) {
    const RigidBodies<dim> magnets({ball<dim>(contact, middle<dim>())});
    return LatticeBoundary<dim>(
             test_lattice<dim>(), all_walls<dim>(WallCondition::stick), magnets.all())
      .constrained(node, velocity);
  };
  const auto without_x = [](Vector<dim> velocity) {
    velocity[0] = 0.;
    return velocity;
  };
  check_velocity(constrained(ContactCondition::stick, in), {});
  check_velocity(constrained(ContactCondition::stick, out), {});
  check_velocity(constrained(ContactCondition::slip, in), without_x(in));
  check_velocity(constrained(ContactCondition::slip, out), without_x(out));
  check_velocity(constrained(ContactCondition::separate, in), without_x(in));
  check_velocity(constrained(ContactCondition::separate, out), out);
  check_velocity(constrained(ContactCondition::none, in), in);
}

TEMPLATE_TEST_CASE_SIG("a moving magnet takes along the nodes inside it",
                       "[boundary]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The same ball with the velocity (3, -2, 0) m/s: the conditions hold for the velocity relative to
  // it. A slower node ahead of it is pushed, a faster one leaves it; once the ball has moved away by
  // 1.5 m, the node is free.
  Index<dim> node = middle_node<dim>();
  node[0] += 2;
  const std::string path = middle<dim>("0 + 3*t; 0.5 - 2*t");
  RigidBodies<dim> magnets({ball<dim>(ContactCondition::separate, path)});
  LatticeBoundary<dim> separate(
    test_lattice<dim>(), all_walls<dim>(WallCondition::stick), magnets.all());
  Vector<dim> slower = some_velocity<dim>(), faster = slower;
  slower[0]          = 1.;
  faster[0]          = 4.;
  Vector<dim> pushed = slower;
  pushed[0]          = 3.;
  // The velocity of a script is a difference quotient, good to nine digits.
  CHECK(norm(separate.constrained(node, slower) - pushed) < 1e-8);
  CHECK(norm(separate.constrained(node, faster) - faster) < 1e-8);
  CHECK(separate.max_speed() == Approx(std::sqrt(13.)).epsilon(1e-8));

  const RigidBodies<dim> sticky({ball<dim>(ContactCondition::stick, path)});
  LatticeBoundary<dim> stick(
    test_lattice<dim>(), all_walls<dim>(WallCondition::stick), sticky.all());
  Vector<dim> of_ball;
  of_ball[0] = 3.;
  of_ball[1] = -2.;
  CHECK(norm(stick.constrained(node, slower) - of_ball) < 1e-8);

  magnets.set_time(0.5);
  check_velocity(separate.constrained(node, slower), slower);
}

TEST_CASE("a node in the centre of a magnet follows it, and one at its surface is free",
          "[boundary]")
{
  // In the very centre any direction may count as outward, here +x: the
  // result must not be 0/0. Nodes at a distance of the radius or more do not belong to the ball.
  const RigidBodies<2> magnets({ball<2>(ContactCondition::slip, middle<2>(), 0.5)});
  const LatticeBoundary<2> boundary(
    test_lattice<2>(), all_walls<2>(WallCondition::slip), magnets.all());
  check_velocity<2>(boundary.constrained({4, 4}, {{1., 2.}}), {{0., 2.}});
  check_velocity<2>(boundary.constrained({5, 4}, {{1., 2.}}), {{0., 2.}});
  check_velocity<2>(boundary.constrained({6, 4}, {{1., 2.}}), {{1., 2.}});
}

TEST_CASE("a magnet cannot push a node through a wall", "[boundary]")
{
  // A ball that moves towards the lower wall has taken a node on that wall in. The wall has the last
  // word: the node may slide, but not leave the box.
  const RigidBodies<2> magnets({ball<2>(ContactCondition::stick, "0; -0.4 - t")});
  const LatticeBoundary<2> boundary(
    test_lattice<2>(), all_walls<2>(WallCondition::slip), magnets.all());
  const Vector<2> velocity = boundary.constrained({4, 0}, {{0.3, 0.7}});
  CHECK(std::abs(velocity[0]) < 1e-8);
  CHECK(velocity[1] == 0.);
  CHECK(boundary.constrained({4, 1}, {{0.3, 0.7}})[1] == Approx(-1.).epsilon(1e-8));
}

TEST_CASE("an open face does nothing to a velocity", "[boundary]")
{
  // Out of the box and into it, on the face and beyond.
  const std::vector<RigidBody<2>> no_bodies;
  const LatticeBoundary<2> boundary(
    test_lattice<2>(), all_walls<2>(WallCondition::open), no_bodies);
  for (int face = 0; face < 4; ++face)
    for (const int beyond : {0, 1})
      for (const double sign : {-1., 1.})
        {
          const Vector<2> velocity = some_velocity<2>(sign);
          CHECK(norm(boundary.constrained(node_on_face<2>(face, beyond), velocity) - velocity) ==
                0.);
        }
}
