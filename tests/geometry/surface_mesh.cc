#include "../catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/geometry/shape.h>
#include <magmpm/motion/pose.h>

#include <cmath>

using namespace magmpm;

namespace
{
  /** The volume that the facets enclose, by the divergence theorem; negative if they face inward. */
  double
  enclosed(const SurfaceMesh<3> &mesh)
  {
    double volume = 0.;
    for (const auto &[a, b, c] : mesh.facets)
      volume += dot(mesh.points[a], cross(mesh.points[b], mesh.points[c])) / 6.;
    return volume;
  }

  double
  enclosed(const SurfaceMesh<2> &mesh)
  {
    double area = 0.;
    for (const auto &[a, b] : mesh.facets)
      area += 0.5 * cross(mesh.points[a], mesh.points[b])[0];
    return area;
  }

  /** Volume of the facets over that of the shape; their points must lie on the surface. */
  template <int dim>
  double
  volume_ratio(const ShapeParameters<dim> &parameters)
  {
    const auto shape            = make_shape(parameters);
    const SurfaceMesh<dim> mesh = shape->surface_mesh(0.005);
    REQUIRE(!mesh.facets.empty());
    double farthest = 0.;
    for (const Vector<dim> &point : mesh.points)
      farthest = std::max(farthest, shape->surface_distance(point).distance);
    CHECK(farthest < 1e-12);
    return enclosed(mesh) / shape->volume_moments().volume;
  }
} // namespace

TEST_CASE("surface meshes of the primitives enclose their volume", "[geometry]")
{
  // The facets of a box are the box. Those of round shapes of radius R with edges s lie inside of it,
  // and miss (2/3 or less in each direction) (pi s/(2 pi R))^2 of the volume: 0.2 % in one direction.
  // All face outward, away from the origin of the coordinates or not.
  ShapeParameters<3> box;
  box.lower_corner = {{1., 2., 3.}};
  box.upper_corner = {{1.5, 2.2, 3.1}};
  CHECK(volume_ratio(box) == Approx(1.));
  ShapeParameters<2> rectangle;
  rectangle.lower_corner = {{1., 2.}};
  rectangle.upper_corner = {{1.5, 2.2}};
  CHECK(volume_ratio(rectangle) == Approx(1.));

  ShapeParameters<3> ball;
  ball.type   = ShapeType::sphere;
  ball.centre = {{1., 2., 3.}};
  ball.radius = 0.1;
  CHECK(volume_ratio(ball) == Approx(0.999).margin(0.001));
  ShapeParameters<2> disc;
  disc.type   = ShapeType::sphere;
  disc.centre = {{1., 2.}};
  disc.radius = 0.1;
  CHECK(volume_ratio(disc) == Approx(0.999).margin(0.001));
  ShapeParameters<3> cylinder = ball;
  cylinder.type               = ShapeType::cylinder;
  cylinder.axis               = {{1., 1., 0.3}};
  cylinder.length             = 0.5;
  CHECK(volume_ratio(cylinder) == Approx(0.999).margin(0.001));
}

TEST_CASE("surface meshes of rings, tubes and combinations enclose their volume", "[geometry]")
{
  // As those of the primitives: facets of round shapes lie inside them, those of a hole inside the hole,
  // so that a tube is enclosed to 0.5 %. Where two surfaces meet, facets are cut at distances that are
  // interpolated along their edges.
  ShapeParameters<3> tube;
  tube.type         = ShapeType::tube;
  tube.centre       = {{1., 2., 3.}};
  tube.radius       = 0.1;
  tube.inner_radius = 0.06;
  tube.axis         = {{1., 1., 0.3}};
  tube.length       = 0.1;
  const auto ratio  = [](const auto &parameters) {
    const auto shape = make_shape(parameters);
    return enclosed(shape->surface_mesh(0.005)) / shape->volume_moments().volume;
  };
  CHECK(ratio(tube) == Approx(1.).margin(0.005));
  ShapeParameters<3> torus = tube;
  torus.type               = ShapeType::ring;
  CHECK(ratio(torus) == Approx(0.99).margin(0.01));
  ShapeParameters<2> ring;
  ring.type         = ShapeType::ring;
  ring.centre       = {{1., 2.}};
  ring.radius       = 0.1;
  ring.inner_radius = 0.06;
  CHECK(ratio(ring) == Approx(1.).margin(0.002));

  ShapeParameters<3> box;
  box.lower_corner        = {{0.95, 1.95, 2.9}};
  box.upper_corner        = {{1.05, 2.2, 3.1}};
  ShapeParameters<3> ball = tube;
  ball.type               = ShapeType::sphere;
  for (const ShapeType type : {ShapeType::union_of, ShapeType::difference, ShapeType::intersection})
    {
      ShapeParameters<3> both;
      both.type  = type;
      both.parts = {box, ball};
      CHECK(ratio(both) == Approx(1.).margin(0.01));
    }
}

TEST_CASE("a rotation vector is that of its rotation", "[geometry]")
{
  // There and back for small angles, large ones and half a turn, where the sign of the axis is free.
  for (const double angle : {0., 1e-9, 0.3, 2., 3.14, constants::pi})
    {
      const Vector<3> vector = (angle / std::sqrt(14.)) * Vector<3>{{1., -2., 3.}};
      const Vector<3> found  = rotation_vector<3>(rotation_by<3>(vector));
      CHECK(std::min(norm(found - vector), norm(found + vector) + (angle < 3.14159 ? 10. : 0.)) <
            1e-12);
    }
  CHECK(rotation_vector<2>(rotation_by<2>({{-2.5}}))[0] == Approx(-2.5));
}
