#include "../catch.h"

#include <magmpm/io/body_geometry.h>

#include <cmath>

using namespace magmpm;

namespace
{
  BodyParameters<3>
  cylinder(const Vector<3> &axis)
  {
    BodyParameters<3> body;
    body.shape  = ShapeType::cylinder;
    body.centre = {{1., 2., 3.}};
    body.radius = 0.5;
    body.length = 4.;
    body.axis   = axis;
    return body;
  }

  BodyParameters<3>
  box(const Vector<3> &lower, const Vector<3> &upper)
  {
    BodyParameters<3> body;
    body.lower_corner = lower;
    body.upper_corner = upper;
    return body;
  }

  BodyParameters<3>
  sphere(const Vector<3> &centre, const double radius)
  {
    BodyParameters<3> body;
    body.shape  = ShapeType::sphere;
    body.centre = centre;
    body.radius = radius;
    return body;
  }
} // namespace

// The box around a cylinder along z is known at sight; at 45 degrees in the xz-plane its caps, half a
// metre in radius and two metres from the centre, reach (2 + 0.5)/sqrt(2) along x and z.
TEST_CASE("The box around a cylinder", "[io]")
{
  const Extent<3> upright = extent(cylinder({{0., 0., 7.}}));
  CHECK(upright.lower[0] == Approx(0.5));
  CHECK(upright.upper[1] == Approx(2.5));
  CHECK(upright.upper[2] == Approx(5.));

  const Extent<3> tilted = extent(cylinder({{1., 0., 1.}}));
  CHECK(tilted.upper[0] == Approx(1. + 2.5 / std::sqrt(2.)));
  CHECK(tilted.lower[1] == Approx(1.5));
  CHECK(tilted.lower[2] == Approx(3. - 2.5 / std::sqrt(2.)));
}

// Distances from a face, an edge and the inside of each shape, which are lengths of right-angled
// triangles (3, 4, 5).
TEST_CASE("The distance of a point from a body", "[io]")
{
  const BodyParameters<3> unit_box = box({{0., 0., 0.}}, {{1., 1., 1.}});
  CHECK(distance(unit_box, {{0.5, 0.5, 0.9}}) == 0.);
  CHECK(distance(unit_box, {{0.5, 0.5, 3.}}) == Approx(2.));
  CHECK(distance(unit_box, {{4., 5., 0.5}}) == Approx(5.));

  CHECK(distance(sphere({{0., 0., 0.}}, 2.), {{3., 4., 0.}}) == Approx(3.));
  CHECK(distance(sphere({{0., 0., 0.}}, 2.), {{1., 1., 0.}}) == 0.);

  const BodyParameters<3> upright = cylinder({{0., 0., 1.}});
  CHECK(distance(upright, {{1., 2., 4.5}}) == 0.);
  CHECK(distance(upright, {{1., 5.5, 3.}}) == Approx(3.));
  CHECK(distance(upright, {{4.5, 2., 9.}}) == Approx(5.));
}

// Bodies that touch do not overlap; a small shift towards each other makes them.
TEST_CASE("Which bodies overlap", "[io]")
{
  const BodyParameters<3> unit_box = box({{0., 0., 0.}}, {{1., 1., 1.}});
  CHECK_FALSE(overlap(unit_box, box({{1., 0., 0.}}, {{2., 1., 1.}})));
  CHECK(overlap(unit_box, box({{0.99, 0.5, 0.5}}, {{2., 2., 2.}})));
  CHECK_FALSE(overlap(unit_box, sphere({{0.5, 0.5, 1.5}}, 0.5)));
  CHECK(overlap(unit_box, sphere({{0.5, 0.5, 1.49}}, 0.5)));
  CHECK(overlap(sphere({{0., 0., 0.}}, 1.), sphere({{1.9, 0., 0.}}, 1.)));
}
