// What a shape fills of a cell: of a cut by a plane, of all kinds of shapes, and of shapes made of others.

#include "../catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/geometry/box_shape.h>
#include <magmpm/geometry/column_moments.h>
#include <magmpm/geometry/combined_shape.h>
#include <magmpm/geometry/mesh_shape.h>
#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/motion/pose.h>

#include "shape_checks.h"
#include "test_meshes.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  /** Moments of the parts of a shape in the cells of a lattice around it, summed. */
  template <int dim>
  VolumeMoments<dim>
  sum_of_parts(const Shape<dim> &shape, const double spacing)
  {
    const BoundingBox<dim> reach = shape.bounding_box();
    RegionMoments<dim> sum;
    Vector<dim> lower = reach.lower;
    for (int d = 0; d < dim; ++d)
      lower[d] -= (0.31 + 0.2 * d) * spacing; // at no special place
    const Vector<dim> start = lower;
    while (lower[dim - 1] < reach.upper[dim - 1])
      {
        BoundingBox<dim> cell = {lower, lower};
        for (int d = 0; d < dim; ++d)
          cell.upper[d] += spacing;
        sum += moved_to(shape.moments_within(cell), reach.lower - middle_of(cell));
        lower[0] += spacing;
        for (int d = 0; d + 1 < dim && lower[d] >= reach.upper[d]; ++d)
          {
            lower[d] = start[d];
            lower[d + 1] += spacing;
          }
      }
    return about_centroid(sum, reach.lower);
  }

  /** Relative differences of volume and second moments, and that of centroids over the spacing. */
  template <int dim>
  double
  error_of_parts(const Shape<dim> &shape, const double spacing)
  {
    const VolumeMoments<dim> found = sum_of_parts(shape, spacing), exact = shape.volume_moments();
    return std::max(
      {std::abs(found.volume / exact.volume - 1.),
       norm(found.centroid - exact.centroid) / spacing,
       frobenius_norm(found.second + -1. * exact.second) / frobenius_norm(exact.second)});
  }

  template <int dim>
  ShapeParameters<dim>
  box_between(const Vector<dim> &lower, const Vector<dim> &upper)
  {
    ShapeParameters<dim> box;
    box.lower_corner = lower;
    box.upper_corner = upper;
    return box;
  }

  template <int dim>
  ShapeParameters<dim>
  ball_at(const Vector<dim> &centre, const double radius)
  {
    ShapeParameters<dim> ball;
    ball.type   = ShapeType::sphere;
    ball.centre = centre;
    ball.radius = radius;
    return ball;
  }

  /** Around the origin; a slanted axis. */
  ShapeParameters<3>
  round_about_axis(const ShapeType type,
                   const double radius,
                   const double inner,
                   const double length)
  {
    ShapeParameters<3> shape = ball_at<3>({}, radius);
    shape.type               = type;
    shape.axis               = {{0.3, -0.5, 0.8}};
    shape.inner_radius       = inner;
    shape.length             = length;
    return shape;
  }

  template <int dim>
  std::unique_ptr<Shape<dim>>
  combined(const ShapeType type, const std::vector<ShapeParameters<dim>> &parts)
  {
    ShapeParameters<dim> shape;
    shape.type  = type;
    shape.parts = parts;
    return make_shape(shape);
  }

  double
  volume(const Shape<3> &shape)
  {
    return shape.volume_moments().volume;
  }
} // namespace

// The corner that a plane x + y + z = s cuts off a cube is a tetrahedron, in 2D x + y = s a triangle, whose
// integrals of 1, x, x^2 and xy are s^n over a factorial. Both sides of a plane make the whole cube.
TEST_CASE("The part of a cube below a plane", "[geometry]")
{
  const double s            = 0.7;
  const Vector<3> centre    = {{0.5, 0.5, 0.5}};
  const BoundingBox<3> cube = {{}, {{1., 1., 1.}}};
  const auto corner = moved_to(moments_below_plane<3>(cube, 1.5 - s, {{1., 1., 1.}}), -1. * centre);
  CHECK(corner.volume == Approx(std::pow(s, 3) / 6.));
  CHECK(corner.first[1] == Approx(std::pow(s, 4) / 24.));
  CHECK(corner.second(2, 2) == Approx(std::pow(s, 5) / 60.));
  CHECK(corner.second(0, 2) == Approx(std::pow(s, 5) / 120.));

  const auto triangle = moved_to<2>(moments_below_plane<2>({{}, {{1., 1.}}}, 1. - s, {{1., 1.}}),
                                    {{-0.5, -0.5}});
  CHECK(triangle.volume == Approx(s * s / 2.));
  CHECK(triangle.first[0] == Approx(std::pow(s, 3) / 6.));
  CHECK(triangle.second(1, 1) == Approx(std::pow(s, 4) / 12.));
  CHECK(triangle.second(0, 1) == Approx(std::pow(s, 4) / 24.));

  std::mt19937 engine(3);
  for (int i = 0; i < 50; ++i)
    {
      const Vector<3> g = random_point(engine, BoundingBox<3>{{{-1., -1., -1.}}, {{1., 1., 1.}}});
      const double f    = 0.5 * random_point(engine, BoundingBox<2>{{{-1., 0.}}, {{1., 1.}}})[0];
      const auto rest   = moments_of(cube) - moments_below_plane(cube, f, g) -
                        moments_below_plane(cube, -f, -1. * g);
      CHECK(std::abs(rest.volume) + norm(rest.first) + frobenius_norm(rest.second) < 1e-14);
    }
}

// The parts in cells, summed, against the formulas of the whole shape: to rounding for boxes and meshes, to
// 0.1 % for a sphere of 4 cells and others, which are cut by planes, to 0.5 % for walls of a tenth of a cell.
TEST_CASE("The parts of a shape add up to it", "[geometry]")
{
  CHECK(error_of_parts(BoxShape<2>({{0.3, -1.}}, {{1.3, 0.5}}), 0.23) < 1e-13);
  CHECK(error_of_parts(BoxShape<3>({{0.3, -1., 2.}}, {{1.3, 0.5, 2.05}}), 0.23) < 1e-13);

  TriangleMesh mesh = cylinder_mesh(0.4, 0.1, 40);
  transform(1., rotation_by<3>({{0.4, 0.3, -0.7}}), {{0.1, 0.2, 0.3}}, mesh);
  CHECK(error_of_parts(MeshShape(mesh), 0.21) < 1e-12);
  // A cavity with something in it, parts as turn_outward() leaves them.
  const TriangleMesh nested =
    joined(joined(unit_sphere(2), turned_over(moved(unit_sphere(2), 0.7, {}))),
           moved(unit_cube(), 0.3, {{-0.1, -0.1, -0.1}}));
  CHECK(error_of_parts(MeshShape(nested), 0.21) < 1e-12);

  CHECK(error_of_parts(*make_shape(ball_at<2>({{0.1, 0.2}}, 4.)), 1.) < 5e-4);
  CHECK(error_of_parts(*make_shape(ball_at<3>({{0.1, 0.2, 0.3}}, 4.)), 1.) < 1e-3);
  CHECK(error_of_parts(*make_shape(ball_at<3>({{0.1, 0.2, 0.3}}, 0.4)), 1.) < 0.01);
  const auto round = [](const ShapeType type, const double inner) {
    return make_shape(round_about_axis(type, 4., inner, 5.));
  };
  CHECK(error_of_parts(*round(ShapeType::cylinder, 0.), 1.) < 1e-3);
  CHECK(error_of_parts(*round(ShapeType::tube, 2.5), 1.) < 1e-3);
  CHECK(error_of_parts(*round(ShapeType::tube, 3.9), 1.) < 5e-3);
  CHECK(error_of_parts(*round(ShapeType::ring, 1.5), 1.) < 1e-3);
  ShapeParameters<2> ring = ball_at<2>({{0.1, 0.2}}, 4.);
  ring.type               = ShapeType::ring;
  ring.inner_radius       = 3.8;
  CHECK(error_of_parts(*make_shape(ring), 1.) < 5e-3);
}

// Every cell for itself: which part of it the shape contains is counted at 20^3 points, whose number errs by
// less than 1 % of the cell where one surface crosses it.
TEST_CASE("The part in a cell is that of the points that a shape contains", "[geometry]")
{
  const auto check = [](const Shape<3> &shape, const double spacing) {
    std::mt19937 engine(5);
    for (int i = 0; i < 60; ++i)
      {
        const Vector<3> lower     = random_point(engine, shape.bounding_box());
        const BoundingBox<3> cell = {lower, lower + Vector<3>{{spacing, spacing, spacing}}};
        constexpr int n           = 20;
        int n_inside              = 0;
        for (int p = 0; p < n * n * n; ++p)
          n_inside += shape.contains(
            lower + (spacing / n) * Vector<3>{{p % n + 0.5, p / n % n + 0.5, p / n / n + 0.5}});
        CHECK(shape.moments_within(cell).volume / volume_of(cell) ==
              Approx(n_inside / double(n * n * n)).margin(0.03));
      }
  };
  check(MeshShape(joined(unit_sphere(3), turned_over(moved(unit_sphere(2), 0.7, {})))), 0.3);
  check(*make_shape(round_about_axis(ShapeType::cylinder, 0.5, 0., 0.4)), 0.3);
  check(*combined<3>(ShapeType::difference,
                     {box_between<3>({}, {{1., 1., 1.}}), ball_at<3>({{0.9, 0.8, 0.7}}, 0.5)}),
        0.3);
}

// Boxes along the axes: inclusion and exclusion of volumes, exactly. Two balls of radius 1 whose centres are
// 1 apart share a lens of 5 pi/12. Shapes that share a face are one without a seam, and what is taken away up to
// the face of the first leaves nothing there.
TEST_CASE("Volumes of unions, differences and intersections", "[geometry]")
{
  const auto a        = box_between<3>({}, {{1., 1., 1.}}),
             b        = box_between<3>({{0.7, 0.6, -0.2}}, {{2., 2., 0.5}});
  const double common = 0.3 * 0.4 * 0.5, of_b = 1.3 * 1.4 * 0.7;
  CHECK(volume(*combined<3>(ShapeType::intersection, {a, b})) == Approx(common).epsilon(1e-9));
  CHECK(volume(*combined<3>(ShapeType::union_of, {a, b})) ==
        Approx(1. + of_b - common).epsilon(1e-9));
  CHECK(volume(*combined<3>(ShapeType::difference, {a, b})) == Approx(1. - common).epsilon(1e-9));

  const auto left = ball_at<3>({}, 1.), right = ball_at<3>({{0., 0.6, 0.8}}, 1.);
  const double lens = 5. * constants::pi / 12., ball = 4. / 3. * constants::pi;
  CHECK(volume(*combined<3>(ShapeType::intersection, {left, right})) == Approx(lens).epsilon(1e-3));
  CHECK(volume(*combined<3>(ShapeType::union_of, {left, right})) ==
        Approx(2. * ball - lens).epsilon(1e-3));
  CHECK(volume(*combined<3>(ShapeType::difference, {left, right})) ==
        Approx(ball - lens).epsilon(1e-3));
  CHECK_THROWS_WITH(combined<3>(ShapeType::difference, {left, left}),
                    "nothing is left of it; move its parts.");

  const auto beside       = box_between<3>({{1., 0., 0.}}, {{1.5, 1., 1.}});
  const auto joined_boxes = combined<3>(ShapeType::union_of, {a, beside});
  CHECK(volume(*joined_boxes) == Approx(1.5).epsilon(1e-12));
  const BoundingBox<3> over_seam = {{{0.93, 0.3, 0.3}}, {{1.03, 0.4, 0.4}}};
  CHECK(joined_boxes->moments_within(over_seam).volume == Approx(1e-3).epsilon(1e-12));
  // A slab of 0.01 between two faces, found without looking at parts of the box.
  const auto slab = combined<3>(ShapeType::intersection,
                                {a, box_between<3>({{0.99, 0., 0.}}, {{2., 1., 1.}})});
  // Of a sliver of 4e-13 of the box, which the second shape covers but for a tenth, no more than that is left.
  const auto sliver = combined<3>(ShapeType::difference,
                                  {box_between<3>({{-1., 0., 0.}}, {{4e-13, 1., 1.}}),
                                   box_between<3>({{-1., 0., 0.}}, {{2., 0.9, 1.}})});
  CHECK(sliver->moments_within({{}, {{1., 1., 1.}}}).volume < 5e-14);
  CHECK(slab->moments_within(over_seam, 0).volume == Approx(1e-4).epsilon(1e-9));
  const auto with_pit = combined<3>(ShapeType::difference,
                                    {a, box_between<3>({{0.2, 0.2, 0.5}}, {{0.8, 0.8, 1.}})});
  CHECK(volume(*with_pit) == Approx(1. - 0.6 * 0.6 * 0.5).epsilon(1e-9));
  const BoundingBox<3> at_mouth = {{{0.4, 0.4, 0.93}}, {{0.5, 0.5, 1.03}}};
  CHECK(with_pit->moments_within(at_mouth).volume < 1e-15);
}

// Where two shapes meet the nearest point is that of the one whose surface is left, and inside of a hole the
// normal points into it. Signs agree with contains(), and surface points lie on the surface and cover it, edges
// that neither of the two has among them.
TEST_CASE("The surface of a shape made of others", "[geometry]")
{
  const auto outer                = box_between<3>({}, {{1., 1., 1.}});
  const auto pit                  = box_between<3>({{0.2, 0.2, 0.5}}, {{0.8, 0.8, 1.5}});
  const auto dish                 = combined<3>(ShapeType::difference, {outer, pit});
  const SurfaceDistance<3> in_pit = dish->surface_distance({{0.5, 0.5, 0.6}});
  CHECK(in_pit.distance == Approx(0.1));
  CHECK(norm(in_pit.normal - Vector<3>{{0., 0., 1.}}) < 1e-12);
  CHECK(dish->surface_distance({{0.5, 0.5, 0.3}}).distance == Approx(-0.2));
  CHECK(dish->surface_distance({{0.5, 0.5, -0.3}}).distance == Approx(0.3));
  check_surface_points(*dish, 0.1);
  const std::vector<Vector<3>> points = dish->surface_points(0.1);
  CHECK(std::any_of(points.begin(), points.end(), [](const Vector<3> &point) {
    return std::abs(point[0] - 0.2) < 1e-9 && std::abs(point[2] - 1.) < 1e-9; // the rim of the pit
  }));
  CHECK(std::none_of(points.begin(), points.end(), [](const Vector<3> &point) {
    return std::abs(point[0] - 0.5) < 0.29 && std::abs(point[1] - 0.5) < 0.29 && point[2] > 0.99;
  }));

  const auto snowman = combined<2>(ShapeType::union_of,
                                   {ball_at<2>({}, 1.), ball_at<2>({{0., 1.2}}, 0.6)});
  check_surface_points(*snowman, 0.1);
  check_surface_points(*make_shape(round_about_axis(ShapeType::ring, 1., 0.4, 0.)), 0.2);
  check_surface_points(*make_shape(round_about_axis(ShapeType::tube, 1., 0.5, 1.)), 0.2);
  std::mt19937 engine(7);
  for (int i = 0; i < 200; ++i)
    {
      const Vector<2> x = random_point(engine, snowman->bounding_box());
      CHECK(snowman->contains(x) == (snowman->surface_distance(x).distance <= 0.));
    }
}

// What a ball cuts out of a box, or of a mesh, lies beside what is left: they share the cut and nothing else, and
// have the volume of the whole, up to what cells cut by planes miss.
TEST_CASE("Parts of a cut shape do not overlap", "[geometry]")
{
  const auto check = [](std::unique_ptr<const Shape<3>> (*body)()) {
    const auto part = [&](const Combination combination) {
      return CombinedShape<3>(combination, body(), make_shape(ball_at<3>({{0.9, 0.8, 0.7}}, 0.5)));
    };
    const CombinedShape<3> left = part(Combination::difference);
    const CombinedShape<3> bite = part(Combination::intersection);
    CHECK(left.volume_moments().volume + bite.volume_moments().volume ==
          Approx(body()->volume_moments().volume).epsilon(1e-4));
    CHECK_FALSE(overlap(left, bite, 0.1));
  };
  check([]() -> std::unique_ptr<const Shape<3>> {
    return std::make_unique<BoxShape<3>>(Vector<3>{}, Vector<3>{{1., 1., 1.}});
  });
  check([]() -> std::unique_ptr<const Shape<3>> {
    return std::make_unique<MeshShape>(moved(unit_sphere(3), 0.7, {{0.5, 0.5, 0.5}}));
  });
}

// A ring touches nothing that is in its hole, though its centroid is there; a ball too large for it does.
TEST_CASE("What is in the hole of a ring does not overlap with it", "[geometry]")
{
  const auto ring = make_shape(round_about_axis(ShapeType::ring, 1., 0.4, 0.));
  CHECK_FALSE(overlap(*ring, *make_shape(ball_at<3>({}, 0.399)), 0.1));
  CHECK_FALSE(overlap(*make_shape(ball_at<3>({}, 0.399)), *ring, 0.1));
  CHECK(overlap(*ring, *make_shape(ball_at<3>({}, 0.45)), 0.1));
}
