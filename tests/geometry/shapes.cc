#include "../catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/cylinder_shape.h>
#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/geometry/sphere_shape.h>

#include "shape_checks.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  const Vector<3> origin = {{0., 0., 0.}};

  const BoxShape<3> unit_box({{0., 0., 0.}}, {{1., 1., 1.}});

  /** Half a metre in radius, four metres long. */
  CylinderShape
  cylinder(const Vector<3> &axis)
  {
    return CylinderShape({{1., 2., 3.}}, axis, 0.5, 4.);
  }
} // namespace

// The box around a cylinder along z is known at sight; at 45 degrees in the xz-plane its caps, half a
// metre in radius and two metres from the centre, reach (2 + 0.5)/sqrt(2) along x and z.
TEST_CASE("The box around a cylinder", "[geometry]")
{
  const BoundingBox<3> upright = cylinder({{0., 0., 7.}}).bounding_box();
  CHECK(upright.lower[0] == Approx(0.5));
  CHECK(upright.upper[1] == Approx(2.5));
  CHECK(upright.upper[2] == Approx(5.));

  const BoundingBox<3> tilted = cylinder({{1., 0., 1.}}).bounding_box();
  CHECK(tilted.upper[0] == Approx(1. + 2.5 / std::sqrt(2.)));
  CHECK(tilted.lower[1] == Approx(1.5));
  CHECK(tilted.lower[2] == Approx(3. - 2.5 / std::sqrt(2.)));
}

// Distances from a face, an edge and from inside of each shape, which are lengths of right-angled
// triangles (3, 4, 5), with the directions of their sides as normals.
TEST_CASE("Distances from primitive shapes and their normals", "[geometry]")
{
  const auto check =
    [](const SurfaceDistance<3> &found, const double distance, const Vector<3> &normal) {
      CHECK(found.distance == Approx(distance));
      CHECK(norm(found.normal - normal) < 1e-12);
    };
  check(unit_box.surface_distance({{0.5, 0.5, 0.9}}), -0.1, {{0., 0., 1.}});
  check(unit_box.surface_distance({{0.2, 0.5, 0.6}}), -0.2, {{-1., 0., 0.}});
  check(unit_box.surface_distance({{0.5, 0.5, 3.}}), 2., {{0., 0., 1.}});
  check(unit_box.surface_distance({{4., 5., 0.5}}), 5., {{0.6, 0.8, 0.}});
  check(unit_box.surface_distance({{-3., 0.5, -4.}}), 5., {{-0.6, 0., -0.8}});

  const SphereShape<3> sphere(origin, 2.);
  check(sphere.surface_distance({{3., 4., 0.}}), 3., {{0.6, 0.8, 0.}});
  check(sphere.surface_distance({{0., 0., -1.}}), -1., {{0., 0., -1.}});
  CHECK(sphere.surface_distance(origin).distance == Approx(-2.));
  CHECK(norm(sphere.surface_distance(origin).normal) == Approx(1.));

  const CylinderShape upright = cylinder({{0., 0., 1.}});
  check(upright.surface_distance({{1., 2., 4.9}}), -0.1, {{0., 0., 1.}});
  check(upright.surface_distance({{1., 2.4, 3.}}), -0.1, {{0., 1., 0.}});
  check(upright.surface_distance({{1., 5.5, 3.}}), 3., {{0., 1., 0.}});
  check(upright.surface_distance({{4.5, 2., 9.}}), 5., {{0.6, 0., 0.8}});
  check(upright.surface_distance({{1., 2., -1.}}), 2., {{0., 0., -1.}});
}

// A cylinder along a slanted axis, whose length is of no importance: points just inside and outside
// of its mantle and of its ends.
TEST_CASE("A cylinder is round about its axis", "[geometry]")
{
  const CylinderShape slanted = cylinder({{3., 0., 4.}});
  const Vector<3> centre      = {{1., 2., 3.}};
  const Vector<3> along = {{0.6, 0., 0.8}}, across = {{-0.8, 0., 0.6}};
  CHECK(slanted.contains(centre + 1.99 * along));
  CHECK_FALSE(slanted.contains(centre + 2.01 * along));
  CHECK(slanted.contains(centre + 1.9 * along + 0.49 * across));
  CHECK_FALSE(slanted.contains(centre + 1.9 * along + 0.51 * across));
}

// Volume, centroid and second moments of each shape against sums over a grid of points that it
// contains: the former come from formulas, the latter from contains() alone. The number of points in
// a round shape errs by the points near its surface, less than a percent here.
TEST_CASE("Moments of primitive shapes are those of the points that they contain", "[geometry]")
{
  check_moments_by_points(BoxShape<2>({{0.3, -1.}}, {{1.3, 0.5}}), 0.003, 0.01);
  check_moments_by_points(SphereShape<2>({{0.3, -1.}}, 0.7), 0.003, 0.01);
  check_moments_by_points(BoxShape<3>({{0.3, -1., 2.}}, {{1.3, 0.5, 2.2}}), 0.013, 0.03);
  check_moments_by_points(SphereShape<3>({{0.3, -1., 2.}}, 0.7), 0.02, 0.01);
  check_moments_by_points(cylinder({{3., 1., 4.}}), 0.03, 0.01);
}

// Points on the surface lie on it, and no point of the surface, as found by going outward from random
// points, is farther from all of them than neighbours are from one another.
TEST_CASE("Surface points of primitive shapes cover the surface", "[geometry]")
{
  check_surface_points(BoxShape<2>({{0.3, -1.}}, {{1.3, 0.5}}), 0.1);
  check_surface_points(SphereShape<2>({{0.3, -1.}}, 0.7), 0.1);
  check_surface_points(BoxShape<3>({{0.3, -1., 2.}}, {{1.3, 0.5, 2.2}}), 0.1);
  check_surface_points(SphereShape<3>({{0.3, -1., 2.}}, 0.7), 0.1);
  check_surface_points(cylinder({{3., 1., 4.}}), 0.2);

  const std::vector<Vector<3>> points = unit_box.surface_points(0.5);
  CHECK(points.size() == 26);
  for (const Vector<3> &corner : {Vector<3>{{0., 1., 0.}}, Vector<3>{{1., 1., 1.}}})
    CHECK(std::any_of(points.begin(), points.end(), [&](const Vector<3> &point) {
      return norm(point - corner) == 0.;
    }));
}

// Bodies that touch do not overlap; a small shift towards each other makes them. Boxes that cross
// like the beams of a plus sign have no corner inside each other; one thing inside another has no
// surface in common with it.
TEST_CASE("Which shapes overlap", "[geometry]")
{
  const auto meet = [](const Shape<3> &a, const Shape<3> &b) {
    CHECK(overlap(a, b, 0.05) == overlap(b, a, 0.05));
    return overlap(a, b, 0.05);
  };
  CHECK_FALSE(meet(unit_box, BoxShape<3>({{1., 0., 0.}}, {{2., 1., 1.}})));
  CHECK(meet(unit_box, BoxShape<3>({{0.99, 0.5, 0.5}}, {{2., 2., 2.}})));
  CHECK(meet(unit_box, BoxShape<3>({{-1., 0.4, 0.4}}, {{2., 0.6, 0.6}})));
  CHECK(meet(unit_box, BoxShape<3>({{0.4, 0.4, 0.4}}, {{0.6, 0.6, 0.6}})));
  CHECK(meet(unit_box, unit_box));
  CHECK_FALSE(meet(unit_box, SphereShape<3>({{0.5, 0.5, 1.5}}, 0.5)));
  CHECK(meet(unit_box, SphereShape<3>({{0.5, 0.5, 1.49}}, 0.5)));
  CHECK(meet(SphereShape<3>(origin, 1.), SphereShape<3>({{1.9, 0., 0.}}, 1.)));
  CHECK_FALSE(meet(SphereShape<3>(origin, 1.), SphereShape<3>({{1.3, 1.6, 0.}}, 1.)));
  CHECK(meet(cylinder({{0., 0., 1.}}), BoxShape<3>({{1.4, 1.9, 2.9}}, {{3., 2.1, 3.1}})));
  CHECK_FALSE(meet(cylinder({{0., 0., 1.}}), BoxShape<3>({{1.4, 2.4, 2.9}}, {{3., 3.1, 3.1}})));
}
