#include <magmpm/boundary/lattice_boundary.h>

#include "catch.h"
#include "cube_of_blocks.h"

using namespace magmpm;
using namespace magmpm::testing;

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
          return LatticeBoundary<dim>(test_lattice<dim>(), walls);
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
  const LatticeBoundary<dim> boundary(test_lattice<dim>(), all_walls<dim>(WallCondition::stick));
  check_velocity(boundary.constrained(middle_node<dim>(), some_velocity<dim>()),
                 some_velocity<dim>());
  for (int face = 0; face < 2 * dim; ++face)
    check_velocity(boundary.constrained(node_on_face<dim>(face, -1), some_velocity<dim>()),
                   some_velocity<dim>());
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
  const LatticeBoundary<3> boundary(test_lattice<3>(), walls);
  check_velocity<3>(boundary.constrained({0, 0, 4}, {{-1., -2., -3.}}), {{0., 0., -3.}});
  check_velocity<3>(boundary.constrained({0, 0, 4}, {{-1., 2., -3.}}), {{0., 2., -3.}});
  check_velocity<3>(boundary.constrained({edge, edge, 4}, {{1., 2., 3.}}), {{0., 0., 3.}});
  check_velocity<3>(boundary.constrained({edge, edge, 4}, {{1., -2., 3.}}), {{0., -2., 3.}});
  check_velocity<3>(boundary.constrained({4, 0, 0}, {{-1., 2., 3.}}), {});
  check_velocity<3>(boundary.constrained({-1, -1, edge + 1}, {{1., 2., 3.}}), {});
}

TEST_CASE("an open face does nothing to a velocity", "[boundary]")
{
  // Out of the box and into it, on the face and beyond.
  const LatticeBoundary<2> boundary(test_lattice<2>(), all_walls<2>(WallCondition::open));
  for (int face = 0; face < 4; ++face)
    for (const int beyond : {0, 1})
      for (const double sign : {-1., 1.})
        {
          const Vector<2> velocity = some_velocity<2>(sign);
          CHECK(norm(boundary.constrained(node_on_face<2>(face, beyond), velocity) - velocity) ==
                0.);
        }
}
