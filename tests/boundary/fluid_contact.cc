#include <magmpm/boundary/fluid_contact.h>
#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/lattice/node_window.h>

#include "catch.h"
#include "cube_of_blocks.h"

#include <cmath>
#include <random>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  constexpr int edge = 16; ///< of the box in cells

  /** A body that is the half space x < @p surface of a frame turned by @p angle about the middle, moving. */
  template <int dim>
  RigidBody<dim>
  half_space(const double surface,
             const double angle,
             const SurfaceContact &contact,
             const RigidMotion<dim> &motion = {})
  {
    Vector<dim> lower, upper, middle;
    for (int d = 0; d < dim; ++d)
      {
        lower[d]  = -10.;
        upper[d]  = 10.;
        middle[d] = 0.8;
      }
    upper[0] = surface;
    Pose<dim> pose;
    pose.position       = middle;
    pose.rotation       = identity<dim>();
    pose.rotation(0, 0) = pose.rotation(1, 1) = std::cos(angle);
    pose.rotation(1, 0)                       = std::sin(angle);
    pose.rotation(0, 1)                       = -std::sin(angle);
    RigidBody<dim> body("wall", std::make_shared<BoxShape<dim>>(lower, upper), contact);
    body.place(pose, motion);
    return body;
  }

  /** Velocities of a function, and random masses. */
  template <int dim, typename Function>
  NodeField<dim>
  field_of(const BlockSet<dim> &blocks, const Function &velocity)
  {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> number(0.5, 2.);
    NodeField<dim> field(blocks.size());
    for_nodes(blocks, [&](const int slot, const int n) {
      field.set(NodeMotion::mass, slot, n, number(generator));
      field.set(NodeMotion::velocity,
                slot,
                n,
                velocity(cube_lattice<dim>(edge, 0.1).node_position(
                  node_of_block<dim>(blocks.block(slot), n))));
    });
    return field;
  }

  /** What contact with @p body leaves. */
  template <int dim>
  NodeField<dim>
  after_contact(const BlockSet<dim> &blocks, const RigidBody<dim> &body, NodeField<dim> field)
  {
    std::vector<RigidBody<dim>> bodies = {body};
    const WallParameters<dim> walls    = all_walls<dim>(WallCondition::open);
    const SolidContact<dim> no_solids(cube_lattice<dim>(edge, 0.1), walls, bodies);
    FluidContact<dim> contact(find_fluid_constraints(
      bodies, no_solids, walls, blocks, cube_lattice<dim>(edge, 0.1), 1e-12, field, MPI_COMM_SELF));
    contact.solve(bodies);
    NodeField<dim> not_wanted;
    contact.apply(
      blocks, LatticeBoundary<dim>(cube_lattice<dim>(edge, 0.1), walls), field, not_wanted);
    return field;
  }

  template <int dim>
  Vector<dim>
  axis(const int d)
  {
    Vector<dim> result;
    result[d] = 1.;
    return result;
  }
} // namespace

// A surface through nodes: the image of a node is a node, and the two of them end with opposite normal
// velocities, as in a mirror; by which the one with less mass changes more, since momentum that goes to one
// with the other's sign is the smallest change: m_g (v_g' - v_g) = m_j (v_j' - v_j). What is tangential stays.
TEMPLATE_TEST_CASE_SIG("A plane through nodes is a mirror", "[boundary]", ((int dim), dim), 2, 3)
{
  const BlockSet<dim> blocks = blocks_of_cube<dim>(edge);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> number(-1., 1.);
  const NodeField<dim> before = field_of<dim>(blocks, [&](const Vector<dim> &) {
    Vector<dim> v;
    for (int d = 0; d < dim; ++d)
      v[d] = number(generator);
    return v;
  });
  // The surface is the plane of the nodes 8, the first of a block; nodes 7 are inside of it.
  const NodeField<dim> after =
    after_contact<dim>(blocks, half_space<dim>(1e-9, 0., {ContactCondition::slip, 0.}), before);
  int n_pairs = 0;
  for_nodes(blocks, [&](const int slot, const int n) {
    const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
    if (node[0] != 9)
      return;
    ++n_pairs;
    const int below = blocks.neighbours(slot)[n_neighbours<dim> / 2 - 1], opposite = n + 2;
    const auto v = [&](const NodeField<dim> &field, const int at, const int number_there) {
      return field.get(NodeMotion::velocity, at, number_there);
    };
    const double m_front  = before.get(NodeMotion::mass, slot, n);
    const double m_behind = before.get(NodeMotion::mass, below, opposite);
    const double expected =
      (m_front * v(before, slot, n)[0] - m_behind * v(before, below, opposite)[0]) /
      (m_front + m_behind);
    CHECK(v(after, slot, n)[0] == Approx(expected).epsilon(1e-6).margin(1e-7));
    CHECK(v(after, below, opposite)[0] == Approx(-expected).epsilon(1e-6).margin(1e-7));
    for (int d = 1; d < dim; ++d)
      CHECK(v(after, slot, n)[d] == v(before, slot, n)[d]);
  });
  CHECK(n_pairs == power(edge, dim - 1));
}

// A velocity that is linear in space and that of the body on its surface, which lies askew between the nodes and moves and
// turns, is what no constraint changes: multilinear weights are exact for it. In a band of 1.5 dx, where nodes have
// images, and away from the edges of the box, where all nodes around an image are there.
TEMPLATE_TEST_CASE_SIG("What moves with a surface is left alone",
                       "[boundary]",
                       ((int dim), dim),
                       2,
                       3)
{
  const BlockSet<dim> blocks = blocks_of_cube<dim>(edge);
  RigidMotion<dim> motion;
  motion.velocity                          = 0.7 * axis<dim>(0) + (-0.4) * axis<dim>(1);
  motion.angular_velocity[0]               = 0.6;
  const std::vector<RigidBody<dim>> bodies = {
    half_space<dim>(0.03, 0.4, {ContactCondition::slip, 0.2}, motion)};
  const RigidBody<dim> &body      = bodies[0];
  const NodeField<dim> field      = field_of<dim>(blocks, [&](const Vector<dim> &position) {
    const SurfaceDistance<dim> surface = body.surface_distance(position);
    return body.velocity_at(position) + (3. * surface.distance) * surface.normal +
           (2. * surface.distance) * axis<dim>(1);
  });
  const WallParameters<dim> walls = all_walls<dim>(WallCondition::open);
  const SolidContact<dim> no_solids(cube_lattice<dim>(edge, 0.1), walls, bodies);
  int n_whole    = 0;
  double largest = 0.;
  for (const FluidConstraint<dim> &constraint : find_fluid_constraints(bodies,
                                                                       no_solids,
                                                                       walls,
                                                                       blocks,
                                                                       cube_lattice<dim>(edge, 0.1),
                                                                       1e-12,
                                                                       field,
                                                                       MPI_COMM_SELF))
    {
      if (std::abs(constraint.weight - 2.) > 1e-6)
        continue;
      ++n_whole;
      Vector<dim> relative = (-constraint.weight) *
                             body.motion().velocity_at(constraint.from_centre);
      for (int t = 0; t < constraint.n_terms; ++t)
        relative += constraint.terms[t].weight * constraint.terms[t].velocity;
      largest = std::max(largest, norm(relative));
    }
  CHECK(n_whole >= edge);
  CHECK(largest < 1e-9);
}

// Material that moves away from a surface: separate lets it go, slip holds it, and one without a surface does not
// touch it. Material that moves into it: all hold it, and friction takes its tangential velocity as far as the
// coefficient times what was taken of the normal one.
TEST_CASE("Surfaces act on fluids by their condition", "[boundary]")
{
  const BlockSet<2> blocks = blocks_of_cube<2>(edge);
  const auto moved =
    [&](const ContactCondition condition, const double friction, const double normal) {
      return field_of<2>(blocks, [&](const Vector<2> &) { return Vector<2>{{normal, 1.}}; });
    };
  const auto change =
    [&](const ContactCondition condition, const double friction, const double normal) {
      const NodeField<2> before = moved(condition, friction, normal);
      const NodeField<2> after =
        after_contact<2>(blocks, half_space<2>(0.03, 0., {condition, friction}), before);
      // Of a node inside, the one of number 8, at 0.3 dx.
      Vector<2> result;
      for_nodes(blocks, [&](const int slot, const int n) {
        if (node_of_block<2>(blocks.block(slot), n) == Index<2>{8, 7})
          result = after.get(NodeMotion::velocity, slot, n) -
                   before.get(NodeMotion::velocity, slot, n);
      });
      return result;
    };
  CHECK(norm(change(ContactCondition::separate, 0.5, 1.)) == 0.);
  CHECK(norm(change(ContactCondition::none, 0.5, -1.)) == 0.);
  CHECK(change(ContactCondition::slip, 0., 1.)[0] < -0.5);
  CHECK(change(ContactCondition::slip, 0., 1.)[1] == 0.);
  CHECK(change(ContactCondition::separate, 0., -1.)[0] > 0.5);
  CHECK(change(ContactCondition::separate, 0., -1.)[1] == 0.);
  const Vector<2> rubbed = change(ContactCondition::separate, 0.2, -1.);
  CHECK(rubbed[1] == Approx(-0.2 * rubbed[0]).epsilon(1e-3));
  CHECK(change(ContactCondition::separate, 10., -1.)[1] == Approx(-1.).epsilon(0.3));
  CHECK(change(ContactCondition::stick, 0., -1.)[1] == Approx(-1.).epsilon(0.3));
}

// Nodes without fluid, and those that are solid for the larger part, are no matter of this contact.
TEST_CASE("Fluid contact leaves solids to their own", "[boundary]")
{
  const BlockSet<2> blocks               = blocks_of_cube<2>(edge);
  const std::vector<RigidBody<2>> bodies = {half_space<2>(0.03, 0., {ContactCondition::slip, 0.})};
  const WallParameters<2> walls          = all_walls<2>(WallCondition::open);
  const NodeField<2> field = field_of<2>(blocks, [](const Vector<2> &) { return Vector<2>(); });
  for (const double share : {0.4, 0.6})
    {
      SolidContact<2> solids(cube_lattice<2>(edge, 0.1), walls, bodies);
      solids.reinit(blocks.size());
      for_nodes(blocks, [&](const int slot, const int n) {
        solids.sums().set(ContactSums::mass, slot, n, share * field.get(NodeMotion::mass, slot, n));
      });
      CHECK(
        find_fluid_constraints(
          bodies, solids, walls, blocks, cube_lattice<2>(edge, 0.1), 1e-12, field, MPI_COMM_SELF)
          .empty() == (share > 0.5));
    }
  const SolidContact<2> no_solids(cube_lattice<2>(edge, 0.1), walls, bodies);
  CHECK(find_fluid_constraints(
          bodies, no_solids, walls, blocks, cube_lattice<2>(edge, 0.1), 1e3, field, MPI_COMM_SELF)
          .empty());
}
