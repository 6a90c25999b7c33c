#include <magmpm/boundary/body_share.h>
#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/boundary/wall_images.h>
#include <magmpm/geometry/sphere_shape.h>
#include <magmpm/lattice/node_window.h>

#include "catch.h"
#include "cube_of_blocks.h"

#include <cmath>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  constexpr int edge = 8; ///< of the box in cells

  template <int dim>
  Lattice<dim>
  box_lattice()
  {
    return cube_lattice<dim>(edge, 0.25);
  }

  /** The blocks of the box and those around it. */
  template <int dim>
  BlockSet<dim>
  blocks_of_box()
  {
    return blocks_of_cube<dim>(edge, 1);
  }

  /** f(node) for mass and momentum of all nodes that particles of the box reach. */
  template <int dim, typename Function>
  NodeField<dim>
  field_of(const BlockSet<dim> &blocks, const Function &f)
  {
    NodeField<dim> field(blocks.size());
    for_nodes(blocks, [&](const int slot, const int n) {
      const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
      for (const int i : node)
        if (i < -1 || i > edge + 1)
          return;
      const std::pair<double, Vector<dim>> value = f(node);
      field.set(NodeMotion::mass, slot, n, value.first);
      field.set(NodeMotion::momentum, slot, n, value.second);
    });
    return field;
  }

  template <int dim>
  SolidContact<dim>
  no_contact(const WallParameters<dim> &walls)
  {
    static const std::vector<RigidBody<dim>> no_bodies;
    return SolidContact<dim>(box_lattice<dim>(), walls, no_bodies);
  }

  bool
  is_beyond(const int i)
  {
    return i < 0 || i > edge;
  }
} // namespace

// A field that is its own mirror image in all walls folds to twice itself next to them, and its velocity comes
// back: v = (sin of the distance, ..) turns around across walls that slip along the normal alone, and is even in
// the rest.
TEMPLATE_TEST_CASE_SIG("Images behind walls are those of a mirror",
                       "[boundary]",
                       ((int dim), dim),
                       2,
                       3)
{
  const BlockSet<dim> blocks = blocks_of_box<dim>();
  const bool sticks          = GENERATE(false, true);
  const auto walls           = all_walls<dim>(sticks ? WallCondition::stick : WallCondition::slip);
  const auto wave            = [](const int i) { return std::sin(M_PI * i / edge); };
  const auto even            = [](const int i) { return 2. + std::cos(M_PI * i / edge); };
  const auto velocity        = [&](const Index<dim> &node) {
    Vector<dim> v;
    for (int c = 0; c < dim; ++c)
      {
        v[c] = 1. + c;
        for (int d = 0; d < dim; ++d)
          v[c] *= (sticks || d == c ? wave(node[d]) : even(node[d]));
      }
    return v;
  };
  const auto mass = [&](const Index<dim> &node) {
    double m = 1.;
    for (int d = 0; d < dim; ++d)
      m *= even(node[d]);
    return m;
  };
  NodeField<dim> field = field_of<dim>(blocks, [&](const Index<dim> &node) {
    return std::make_pair(mass(node), mass(node) * velocity(node));
  });
  WallImages<dim> images(box_lattice<dim>(), walls, true);
  images.fold_sticking(blocks, field);
  images.choose_and_fold(blocks, no_contact<dim>(walls), {}, field);
  for_nodes(blocks, [&](const int slot, const int n) {
    const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
    double twice          = 1.;
    bool is_used          = true;
    for (const int i : node)
      {
        twice *= (i == 1 || i == edge - 1 ? 2. : 1.);
        is_used = is_used && !is_beyond(i);
      }
    const double expected = (is_used ? twice * mass(node) : 0.);
    CHECK(field.get(NodeMotion::mass, slot, n) == Approx(expected).margin(1e-14));
    CHECK(norm(field.get(NodeMotion::momentum, slot, n) - expected * velocity(node)) < 1e-12);
    if (is_used)
      field.set(NodeMotion::velocity, slot, n, velocity(node));
  });
  images.unfold(blocks, field);
  for_nodes(blocks, [&](const int slot, const int n) {
    const Index<dim> node = node_of_block<dim>(blocks.block(slot), n);
    for (const int i : node)
      if (i < -1 || i > edge + 1)
        return;
    CHECK(norm(field.get(NodeMotion::velocity, slot, n) - velocity(node)) < 1e-14);
  });
}

// What moves away from a wall that separates has no image there, unless gravity presses it on within the step;
// one that slips keeps it. Mass and the momentum along the wall are not changed by folding.
TEST_CASE("What leaves a wall that separates has no images", "[boundary]")
{
  const BlockSet<2> blocks = blocks_of_box<2>();
  for (const auto condition : {WallCondition::slip, WallCondition::separate})
    for (const double velocity : {-1., 1.})
      for (const double gravity : {0., -2.})
        {
          CAPTURE(static_cast<int>(condition), velocity, gravity);
          WallParameters<2> walls;
          walls.condition.fill(WallCondition::open);
          walls.condition[2] = condition;
          NodeField<2> field = field_of<2>(blocks, [&](const Index<2> &node) {
            return node[1] <= 1 ? std::make_pair(2., Vector<2>{{3., 2. * velocity}})
                                : std::make_pair(0., Vector<2>());
          });
          WallImages<2> images(box_lattice<2>(), walls, true);
          images.choose_and_fold(blocks, no_contact<2>(walls), {{0., gravity}}, field);
          const bool folds = condition == WallCondition::slip || velocity + gravity < 0.;
          for_nodes(blocks, [&](const int slot, const int n) {
            const Index<2> node = node_of_block<2>(blocks.block(slot), n);
            if (node[0] < 0 || node[0] > edge || node[1] < -1 || node[1] > 1)
              return;
            const double share = (!folds || node[1] == 0 ? 1. : node[1] == 1 ? 2. : 0.);
            CHECK(field.get(NodeMotion::mass, slot, n) == 2. * share);
            CHECK(field.get(NodeMotion::momentum, slot, n)[0] == 3. * share);
            if (folds && node[1] == 1)
              CHECK(field.get(NodeMotion::momentum, slot, n)[1] == 0.);
          });
        }
}

// Without fluids, and where solids are the larger part of a node on the wall, there are no images: solids touch
// walls that slip by their gap.
TEST_CASE("Solids have no images in walls that slip", "[boundary]")
{
  const BlockSet<2> blocks = blocks_of_box<2>();
  const auto walls         = all_walls<2>(WallCondition::slip);
  CHECK_FALSE(WallImages<2>(box_lattice<2>(), walls, false).are_chosen());
  CHECK_FALSE(
    WallImages<2>(box_lattice<2>(), all_walls<2>(WallCondition::stick), true).are_chosen());
  for (const double share : {0.4, 0.6})
    {
      const auto constant     = [](const Index<2> &) { return std::make_pair(2., Vector<2>()); };
      NodeField<2> field      = field_of<2>(blocks, constant);
      SolidContact<2> contact = no_contact<2>(walls);
      contact.reinit(blocks.size());
      for_nodes(blocks, [&](const int slot, const int n) {
        contact.sums().set(ContactSums::mass, slot, n, share * 2.);
      });
      WallImages<2> images(box_lattice<2>(), walls, true);
      images.choose_and_fold(blocks, contact, {}, field);
      double behind = 0.;
      for_nodes(blocks, [&](const int slot, const int n) {
        if (node_of_block<2>(blocks.block(slot), n)[0] < 0)
          behind += field.get(NodeMotion::mass, slot, n);
      });
      CHECK((behind > 0.) == (share > 0.5));
    }
}

// The shares of all nodes in a disc are its area and pi dx^2/4, since its surface curves and counts as plane;
// well inside each is one and outside none.
TEST_CASE("Shares of nodes in a rigid body add up to it", "[boundary]")
{
  const Lattice<2> lattice = box_lattice<2>();
  const BlockSet<2> blocks = blocks_of_box<2>();
  RigidBodyProperties<2> properties;
  Pose<2> pose;
  pose.position       = {{1.03, 0.94}};
  const double radius = 0.7;
  NodeField<2, SingleScalar> field(blocks.size());
  const auto disc = std::make_shared<SphereShape<2>>(Vector<2>(), radius);
  add_share_in_bodies<2>(
    {make_rigid_body<2>("none", disc, properties, pose)}, blocks, lattice, field);
  double area    = 0.;
  const auto add = [&](const int slot, const int n) {
    area += field.get(SingleScalar::value, slot, n) * 0.25 * 0.25;
  };
  for_nodes(blocks, add);
  CHECK(area == 0.); // it has no surface
  properties.contact.condition = ContactCondition::separate;
  add_share_in_bodies<2>(
    {make_rigid_body<2>("disc", disc, properties, pose)}, blocks, lattice, field);
  for_nodes(blocks, add);
  CHECK(area == Approx(M_PI * (radius * radius + 0.25 * 0.25 * 0.25)).epsilon(1e-3));
  for_nodes(blocks, [&](const int slot, const int n) {
    const double distance =
      norm(lattice.node_position(node_of_block<2>(blocks.block(slot), n)) - pose.position) - radius;
    const double share = field.get(SingleScalar::value, slot, n);
    if (distance > 0.375)
      CHECK(share == 0.);
    if (distance < -0.375)
      CHECK(share == 1.);
    CHECK(share >= 0.);
    CHECK(share <= 1.);
  });
}
