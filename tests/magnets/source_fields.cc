// Identities that the fields of all kinds of sources obey, and their limits: each is known without
// the formulas that are tested.

#include <magmpm/magnets/cuboid.h>
#include <magmpm/magnets/current_loop.h>
#include <magmpm/magnets/cylinder.h>
#include <magmpm/magnets/magnetized_mesh.h>
#include <magmpm/magnets/magnetized_sphere.h>
#include <magmpm/magnets/point_dipole.h>
#include <magmpm/magnets/straight_wire.h>

#include "field_checks.h"
#include "geometry/test_meshes.h"

#include <functional>
#include <limits>
#include <memory>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  constexpr double pi = constants::pi;

  template <int dim>
  struct Source
  {
    std::string name;
    std::shared_ptr<SourceField<dim>> field;
    Vector<dim> amplitude;
    /** Distance from the nearest surface, edge or conductor, where the field is not smooth. */
    std::function<double(const Vector<dim> &)> clearance;
  };

  double
  from_box(const Vector<3> &point, const Vector<3> &half)
  {
    double outside = 0., inside = std::numeric_limits<double>::infinity();
    for (int d = 0; d < 3; ++d)
      {
        const double beyond = std::abs(point[d]) - half[d];
        outside             = std::hypot(outside, std::max(beyond, 0.));
        inside              = std::min(inside, std::abs(beyond));
      }
    return outside > 0. ? outside : inside;
  }

  double
  from_cylinder(const Vector<3> &point, const double radius, const double half)
  {
    const double wall = std::hypot(point[0], point[1]) - radius, end = std::abs(point[2]) - half;
    if (wall > 0. || end > 0.)
      return std::hypot(std::max(wall, 0.), std::max(end, 0.));
    return std::min(-wall, -end);
  }

  std::vector<Source<3>>
  spatial_sources()
  {
    const Vector<3> m = 1e6 * oblique<3>(), size = {{1., 0.6, 1.4}}, half = 0.5 * size;
    const Vector<3> current = {{1e3, 0., 0.}};
    const auto from_sphere  = [](const Vector<3> &x) { return std::abs(norm(x) - 0.5); };
    const auto box          = [=](const Vector<3> &x) { return from_box(x, half); };
    const auto tube         = [](const Vector<3> &x) { return from_cylinder(x, 0.5, 0.4); };
    const auto ring         = [](const Vector<3> &x) {
      return std::abs(std::hypot(std::hypot(x[0], x[1]) - 0.6, x[2]) - 0.05);
    };
    const auto wire = [](const Vector<3> &x) { return std::abs(std::hypot(x[0], x[1]) - 0.05); };
    return {{"point dipole", std::make_shared<PointDipole<3>>(0.5), m, from_sphere},
            {"sphere", std::make_shared<MagnetizedSphere<3>>(0.5), m, from_sphere},
            {"cuboid", std::make_shared<Cuboid<3>>(size), m, box},
            {"cylinder", std::make_shared<Cylinder>(0.5, 0.8), m, tube},
            {"mesh", std::make_shared<MagnetizedMesh>(box_mesh(-1. * half, half)), m, box},
            {"loop", std::make_shared<CurrentLoop>(0.6, 0.05), current, ring},
            {"wire", std::make_shared<StraightWire<3>>(0.05), current, wire},
            {"wire with ends", std::make_shared<StraightWire<3>>(0.05, 0.9), current, wire}};
  }

  std::vector<Source<2>>
  plane_sources()
  {
    const Vector<2> m      = 1e6 * oblique<2>();
    const auto from_circle = [](const Vector<2> &x) { return std::abs(norm(x) - 0.5); };
    return {{"line dipole", std::make_shared<PointDipole<2>>(0.5), m, from_circle},
            {"sphere", std::make_shared<MagnetizedSphere<2>>(0.5), m, from_circle},
            {"rectangle",
             std::make_shared<Cuboid<2>>(Vector<2>{{1., 0.6}}),
             m,
             [](const Vector<2> &x) {
               return from_box({{x[0], x[1], 0.}}, {{0.5, 0.3, 1e9}});
             }},
            {"wire", std::make_shared<StraightWire<2>>(0.05), {{1e3, 0.}}, [](const Vector<2> &x) {
               return std::abs(norm(x) - 0.05);
             }}};
  }

  template <int dim>
  std::vector<Source<dim>>
  all_sources()
  {
    if constexpr (dim == 3)
      return spatial_sources();
    else
      return plane_sources();
  }

  bool
  is_current(const std::string &name)
  {
    return name == "loop" || name.rfind("wire", 0) == 0;
  }

  /** Largest distance of two fields at points of a list, relative to the larger field. */
  template <int dim>
  double
  largest_difference(const std::vector<Vector<dim>> &points,
                     const std::function<Vector<dim>(const Vector<dim> &)> &a,
                     const std::function<Vector<dim>(const Vector<dim> &)> &b)
  {
    double largest = 0.;
    for (const Vector<dim> &x : points)
      largest = std::max(largest, norm(a(x) - b(x)) / std::max(norm(a(x)), norm(b(x))));
    return largest;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("the gradient of a source is the derivative of its field",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Differences of fourth order with a step of 1e-3 of the distance from where the field is not smooth
  // leave some 1e-9; inside and outside, near and far.
  for (const Source<dim> &source : all_sources<dim>())
    for (const double reach : {0.9, 4.})
      for (const Vector<dim> &x : scattered_points<dim>(reach, 150))
        {
          const double clearance = source.clearance(x);
          if (clearance < 0.02)
            continue;
          const Matrix<dim> difference =
            difference_gradient(*source.field, source.amplitude, x, 2e-3 * clearance);
          const Matrix<dim> gradient = source.field->field_gradient(source.amplitude, x);
          const double size          = frobenius_norm(gradient) +
                              norm(source.field->field(source.amplitude, x));
          INFO(source.name << " at " << x[0] << ", " << x[1] << ", " << x[dim - 1]);
          CHECK(frobenius_norm(gradient + (-1.) * difference) < 1e-8 * size);
        }
}

TEMPLATE_TEST_CASE_SIG("no source makes a divergence of B, and no curl of H outside",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Maxwell, by differences of the fields alone. M is uniform, so inside div B = mu_0 div H. The curl
  // is the current inside of a conductor, and does not vanish round a wire with ends.
  for (const Source<dim> &source : all_sources<dim>())
    for (const Vector<dim> &x : scattered_points<dim>(1.2, 150))
      {
        const double clearance = source.clearance(x);
        const bool in_loop     = source.name == "loop" && std::abs(x[dim - 1]) < 0.05 &&
                             std::abs(std::hypot(x[0], x[1]) - 0.6) < 0.05;
        if (clearance < 0.02 || in_loop)
          continue;
        const Matrix<dim> gradient =
          difference_gradient(*source.field, source.amplitude, x, 2e-3 * clearance);
        const double size = frobenius_norm(gradient) +
                            norm(source.field->field(source.amplitude, x));
        INFO(source.name << " at " << x[0] << ", " << x[1] << ", " << x[dim - 1]);
        CHECK(std::abs(trace(gradient)) < 1e-8 * size);
        const bool has_curl = source.name == "wire with ends" ||
                              (source.name == "wire" && std::hypot(x[0], x[1]) < 0.05);
        if (!has_curl)
          CHECK(frobenius_norm(gradient + (-1.) * transpose(gradient)) < 1e-8 * size);
      }
}

TEST_CASE("far away a magnet is a dipole", "[magnets]")
{
  // Of moment M V, I pi R^2 for a loop. The next moments of these shapes are two powers of a/r
  // smaller: some 1e-5 at 200 sizes away. Near the magnet the difference is large.
  const double volumes[]               = {1., pi / 6., 0.84, pi * 0.2, 0.84};
  const std::vector<Source<3>> sources = spatial_sources();
  for (int s = 0; s < 6; ++s)
    {
      const Source<3> &source = sources[s];
      const Vector<3> moment  = s < 5 ? volumes[s] * source.amplitude
                                      : Vector<3>{{0., 0., 1e3 * pi * 0.36}};
      const auto field        = [&](const Vector<3> &x) {
        return source.field->field(source.amplitude, x);
      };
      const auto dipole = [&](const Vector<3> &x) { return dipole_field(moment, x); };
      std::vector<Vector<3>> far, near;
      for (const Vector<3> &x : scattered_points<3>(1., 50))
        {
          far.push_back((200. / norm(x)) * x);
          near.push_back((1. / norm(x)) * x);
        }
      INFO(source.name);
      CHECK(largest_difference<3>(far, field, dipole) < 3e-5);
      if (s >= 2)
        CHECK(largest_difference<3>(near, field, dipole) > 0.05);
    }

  const Vector<2> m = 1e6 * oblique<2>();
  const Cuboid<2> rectangle(Vector<2>{{1., 0.6}});
  for (const Vector<2> &x : scattered_points<2>(1., 20))
    {
      const Vector<2> point = (200. / norm(x)) * x;
      CHECK(norm(rectangle.field(m, point) - dipole_field(0.6 * m, point)) <
            3e-5 * norm(dipole_field(0.6 * m, point)));
    }
}

TEST_CASE("two half cuboids are one cuboid", "[magnets]")
{
  // Superposition: the charges on the faces where they meet cancel. Inside, outside, and their gradients.
  const Vector<3> m = 1e6 * oblique<3>();
  const Cuboid<3> whole(Vector<3>{{1., 0.6, 1.4}});
  const Cuboid<3> half(Vector<3>{{0.4, 0.6, 1.4}}), rest(Vector<3>{{0.6, 0.6, 1.4}});
  for (const Vector<3> &x : scattered_points<3>(1., 200))
    {
      const Vector<3> a = x - Vector<3>{{-0.3, 0., 0.}}, b = x - Vector<3>{{0.2, 0., 0.}};
      // Within one half the other is outside: B = H + M of the whole.
      CHECK(norm(whole.field(m, x) - half.field(m, a) - rest.field(m, b)) < 1e-13 * norm(m));
      const Matrix<3> gradient = whole.field_gradient(m, x);
      CHECK(frobenius_norm(gradient + (-1.) * half.field_gradient(m, a) +
                           (-1.) * rest.field_gradient(m, b)) <
            1e-11 * frobenius_norm(gradient) + 1e-6);
    }
}

TEST_CASE("a long cuboid is a rectangle in the plane, an endless wire one across it", "[magnets]")
{
  // In 2D everything is infinite along z. A cuboid 2000 times as long as wide lacks some 1e-7 of it.
  const Cuboid<3> bar(Vector<3>{{1., 0.6, 2000.}});
  const Cuboid<2> rectangle(Vector<2>{{1., 0.6}});
  const StraightWire<3> wire(0.05);
  const StraightWire<2> line(0.05);
  for (const Vector<2> &x : scattered_points<2>(1., 100))
    {
      const Vector<2> m = 1e6 * oblique<2>(), plane = rectangle.field(m, x);
      const Vector<3> field = bar.field({{m[0], m[1], 0.}}, {{x[0], x[1], 0.3}});
      CHECK(std::hypot(field[0] - plane[0], field[1] - plane[1]) < 1e-6 * norm(m));
      const Vector<3> round = wire.field({{7., 0., 0.}}, {{x[0], x[1], 4.}});
      CHECK(norm(line.field({{7., 0.}}, x) - Vector<2>{{round[0], round[1]}}) == 0.);
    }
}

TEST_CASE("a long cylinder magnetized along its axis is a solenoid", "[magnets]")
{
  // B on the axis of a sheet of current M per length: mu_0 M/2 (cos a_0 + cos a_1), a the angles to the
  // rims; without ends mu_0 M inside everywhere and nothing outside.
  const Cylinder cylinder(0.5, 0.8), endless(0.5, 2000.);
  const Vector<3> m = {{0., 0., 1e6}};
  for (const double z : {-3., -0.9, -0.2, 0., 0.37, 0.5, 2.})
    {
      const double upper = z + 0.4, lower = z - 0.4;
      const double b = 0.5 * (upper / std::hypot(upper, 0.5) - lower / std::hypot(lower, 0.5));
      const double h = b - (std::abs(z) < 0.4 ? 1. : 0.);
      CHECK(cylinder.field(m, {{0., 0., z}})[2] == Approx(1e6 * h).epsilon(1e-13));
    }
  for (const double rho : {0., 0.2, 0.499, 0.501, 2.})
    CHECK(norm(endless.field(m, {{rho, 0., 3.}})) < 1e-6 * 1e6);
  // Across its axis it is demagnetized by half: the cylinder of 2D.
  const MagnetizedSphere<2> circle(0.5);
  for (const double rho : {0., 0.2, 0.49, 0.51, 2.})
    {
      const Vector<3> field = endless.field({{8e5, 6e5, 0.}}, {{0.6 * rho, -0.8 * rho, 3.}});
      const Vector<2> plane = circle.field({{8e5, 6e5}}, {{0.6 * rho, -0.8 * rho}});
      CHECK(norm(Vector<2>{{field[0], field[1]}} - plane) < 1e-6 * 1e6);
    }
}

TEST_CASE("the mesh of a cuboid is the cuboid", "[magnets]")
{
  // The same charges by two formulas: triangles, and rectangles. Also in the middle of a face, which is
  // on the side between two triangles.
  const Vector<3> m = 1e6 * oblique<3>(), size = {{1., 0.6, 1.4}};
  const Cuboid<3> cuboid(size);
  const MagnetizedMesh mesh(box_mesh(-0.5 * size, 0.5 * size));
  std::vector<Vector<3>> points = scattered_points<3>(1., 200);
  points.push_back({{0.5, 0., 0.}});
  points.push_back({{0., -0.3, 0.1}});
  for (const Vector<3> &x : points)
    {
      CHECK(norm(cuboid.field(m, x) - mesh.field(m, x)) < 1e-8 * norm(m));
      const Matrix<3> gradient = cuboid.field_gradient(m, x);
      CHECK(frobenius_norm(gradient + (-1.) * mesh.field_gradient(m, x)) <
            1e-10 * frobenius_norm(gradient));
    }
}

TEST_CASE("finer meshes come near to a sphere and to a cylinder", "[magnets]")
{
  // Facets miss the sphere and the cylinder by the square of their width: half of it, a quarter of the
  // error.
  const Vector<3> m = 1e6 * oblique<3>();
  const MagnetizedSphere<3> sphere(1.);
  const Cylinder cylinder(0.5, 0.8);
  const auto error =
    [&](const SourceField<3> &exact, const MagnetizedMesh &mesh, const Vector<3> &x) {
      return norm(exact.field(m, x) - mesh.field(m, x)) / norm(m);
    };
  const MagnetizedMesh coarse(sphere_mesh(12)), fine(sphere_mesh(24));
  const MagnetizedMesh sides24(cylinder_mesh(0.5, 0.8, 24)), sides48(cylinder_mesh(0.5, 0.8, 48));
  for (const Vector<3> &x :
       std::vector<Vector<3>>{{{0.1, -0.2, 0.3}}, {{0.9, 0.7, -1.}}, {{0., 0., 2.}}})
    {
      CHECK(error(sphere, coarse, x) < 0.03);
      CHECK(error(sphere, coarse, x) / error(sphere, fine, x) == Approx(4.).epsilon(0.1));
      CHECK(error(cylinder, sides24, x) < 0.01);
      CHECK(error(cylinder, sides24, x) / error(cylinder, sides48, x) == Approx(4.).epsilon(0.1));
    }
}

TEST_CASE("a cylinder has the field of the charges on its surface", "[magnets]")
{
  // The integral of M.n r/(4 pi r^3) over wall and ends by a fine midpoint rule, exponentially exact
  // round the axis; at points half a radius away, for M of any direction. Near the axis, on both sides
  // of where the formulas change (a third and three times the radius), and beside the rim.
  const double radius = 0.5, half = 0.4;
  const Cylinder cylinder(radius, 2. * half);
  const Vector<3> m = 1e6 * oblique<3>();
  constexpr int n = 400, n_angles = 96;
  for (const Vector<3> &x : std::vector<Vector<3>>{{{0., 0., 1.}},
                                                   {{0.15, 0.05, 0.8}},
                                                   {{0.17, 0., -0.85}},
                                                   {{1.0, 0.2, 0.1}},
                                                   {{0.35, 0.3536, 0.9}},
                                                   {{-1.1, 1., -0.3}},
                                                   {{0., -1.6, 1.}}})
    {
      Vector<3> sum;
      const auto add = [&](const Vector<3> &y, const Vector<3> &normal, const double area) {
        const Vector<3> r = x - y;
        sum += (dot(m, normal) * area / (4. * pi * std::pow(norm(r), 3))) * r;
      };
      for (int a = 0; a < n_angles; ++a)
        {
          const Vector<3> e = {
            {std::cos(2. * pi * a / n_angles), std::sin(2. * pi * a / n_angles), 0.}};
          for (int i = 0; i < n; ++i)
            {
              const double z = half * ((2. * i + 1.) / n - 1.), rho = radius * (i + 0.5) / n;
              const double arc = 2. * pi / n_angles;
              add(radius * e + Vector<3>{{0., 0., z}}, e, radius * arc * 2. * half / n);
              for (const double side : {-1., 1.})
                add(rho * e + Vector<3>{{0., 0., side * half}},
                    {{0., 0., side}},
                    rho * arc * radius / n);
            }
        }
      CHECK(norm(cylinder.field(m, x) - sum) < 3e-6 * norm(sum));
    }
}

TEST_CASE("H jumps by the normal magnetization through every face", "[magnets]")
{
  // B has no divergence and H no curl: n.H gains n.M from inside to outside, the rest goes through. On
  // the surface itself the outside counts.
  const Vector<3> m     = 1e6 * oblique<3>();
  const auto check_jump = [&](const SourceField<3> &field, const Vector<3> &x, const Vector<3> &n) {
    const Vector<3> outside = field.field(m, x + 1e-7 * n), inside = field.field(m, x - 1e-7 * n);
    CHECK(norm(outside - inside - dot(m, n) * n) < 1e-5 * norm(m));
    CHECK(norm(field.field(m, x) - outside) < 1e-5 * norm(m));
  };
  const Vector<3> size = {{1., 0.6, 1.4}};
  const Cuboid<3> cuboid(size);
  const MagnetizedMesh mesh(box_mesh(-0.5 * size, 0.5 * size));
  for (int d = 0; d < 3; ++d)
    for (const double side : {-1., 1.})
      {
        Vector<3> n, x = 0.2 * size;
        n[d] = side;
        x[d] = side * 0.5 * size[d];
        check_jump(cuboid, x, n);
        check_jump(mesh, x, n);
      }
  const Cylinder cylinder(0.5, 0.8);
  check_jump(cylinder, {{0.2, 0.1, 0.4}}, {{0., 0., 1.}});
  check_jump(cylinder, {{0.2, 0.1, -0.4}}, {{0., 0., -1.}});
  check_jump(cylinder, {{0., 0., 0.4}}, {{0., 0., 1.}});
  check_jump(cylinder, {{0.3, -0.4, 0.1}}, {{0.6, -0.8, 0.}});

  const Cuboid<2> rectangle(Vector<2>{{1., 0.6}});
  const Vector<2> m2 = 1e6 * oblique<2>();
  for (int d = 0; d < 2; ++d)
    for (const double side : {-1., 1.})
      {
        Vector<2> n, x = {{0.1, 0.1}};
        n[d]                 = side;
        x[d]                 = side * (d == 0 ? 0.5 : 0.3);
        const Vector<2> jump = rectangle.field(m2, x + 1e-7 * n) -
                               rectangle.field(m2, x - 1e-7 * n);
        CHECK(norm(jump - dot(m2, n) * n) < 1e-5 * norm(m2));
        CHECK(norm(rectangle.field(m2, x) - rectangle.field(m2, x + 1e-7 * n)) < 1e-5 * norm(m2));
      }
}

TEST_CASE("a current loop is exact on its axis, and a small one is a dipole", "[magnets]")
{
  // H = I R^2/(2 (R^2 + z^2)^(3/2)) on the axis; the dipole I pi R^2 far away; and round the conductor
  // the line integral of H is the current (Ampere), inside the part of the area.
  const CurrentLoop loop(0.6, 0.05);
  for (const double z : {-2., 0., 0.3, 5.})
    CHECK(loop.field({{3., 0., 0.}}, {{0., 0., z}})[2] ==
          Approx(3. * 0.36 / (2. * std::pow(0.36 + z * z, 1.5))).epsilon(1e-14));

  const CurrentLoop small(1e-3, 1e-4);
  for (const Vector<3> &x : scattered_points<3>(1., 20))
    {
      const Vector<3> dipole = dipole_field({{0., 0., 3. * pi * 1e-6}}, x);
      CHECK(norm(small.field({{3., 0., 0.}}, x) - dipole) < 1e-4 * norm(dipole));
    }

  for (const double distance : {0.01, 0.04, 0.05, 0.2, 0.5})
    {
      double circulation = 0.;
      constexpr int n    = 2000;
      for (int i = 0; i < n; ++i)
        {
          const double angle = 2. * pi * i / n;
          const Vector<3> H  = loop.field(
            {{3., 0., 0.}}, {{0.6 + distance * std::cos(angle), 0., distance * std::sin(angle)}});
          circulation += (-std::sin(angle) * H[0] + std::cos(angle) * H[2]) * 2. * pi * distance /
                         n;
        }
      // The current goes along y at x = 0.6, against the sense from x to z.
      const double part = std::min(1., std::pow(distance / 0.05, 2));
      CHECK(circulation == Approx(-3. * part).epsilon(1e-9));
    }
}

TEST_CASE("within its conductor the field of a loop has its gradient too", "[magnets]")
{
  // Differences of the field again, at points inside: none on average are among scattered ones.
  const CurrentLoop loop(0.6, 0.05);
  const Vector<3> current = {{1e3, 0., 0.}};
  for (const Vector<3> &off : std::vector<Vector<3>>{{{0.02, 0., 0.01}}, {{-0.01, 0., -0.03}}})
    {
      const Vector<3> x = Vector<3>{{0.36, 0.48, 0.}} +
                          Vector<3>{{0.6 * off[0], 0.8 * off[0], off[2]}};
      const Matrix<3> difference = difference_gradient(loop, current, x, 1e-4);
      const Matrix<3> gradient   = loop.field_gradient(current, x);
      CHECK(frobenius_norm(gradient + (-1.) * difference) < 1e-8 * frobenius_norm(gradient));
      CHECK(frobenius_norm(gradient) > 1e3 / (2. * pi * 0.05 * 0.05));
    }
}

TEST_CASE("a long wire is one without ends", "[magnets]")
{
  // I/(2 pi rho), and half of that beside the end of a half-infinite one; within the conductor it goes
  // to zero linearly.
  const StraightWire<3> endless(0.01), lengthy(0.01, 1e4);
  const Vector<3> current = {{5., 0., 0.}};
  const Vector<3> x       = {{0.3, 0.4, 2.}};
  CHECK(norm(endless.field(current, x)) == Approx(5. / (2. * pi * 0.5)).epsilon(1e-14));
  CHECK(endless.field(current, x)[0] < 0.); // right hand
  CHECK(norm(lengthy.field(current, x) - endless.field(current, x)) < 1e-8);
  CHECK(norm(lengthy.field(current, {{0.3, 0.4, 5000.}})) ==
        Approx(5. / (4. * pi * 0.5)).epsilon(1e-8));
  CHECK(norm(endless.field(current, {{0.005, 0., 0.}})) == Approx(0.5 * 5. / (2. * pi * 0.01)));
  CHECK(norm(endless.field(current, {{0., 0., 1.}})) == 0.);
  // Beyond its end on the axis nothing, and close beside the axis next to nothing.
  CHECK(norm(StraightWire<3>(0.01, 1.).field(current, {{0., 0., 0.7}})) == 0.);
  CHECK(norm(StraightWire<3>(1e-9, 1.).field(current, {{1e-7, 0., 0.7}})) ==
        Approx(5. / (4. * pi) * 1e-7 * 0.5 * (1. / 0.04 - 1. / 1.44)).epsilon(1e-9));
}

TEMPLATE_TEST_CASE_SIG("fields are finite everywhere", "[magnets]", ((int dim), dim), 2, 3)
{
  // Centres, axes, faces, edges and their extensions, corners, conductors; and all around them at a
  // distance of rounding. At an edge no field is beyond 5 M, and no gradient beyond 2e4 M over a size.
  std::vector<double> places;
  for (const double x : {0., 0.05, 0.3, 0.4, 0.45, 0.5, 0.6, 0.7, 1.})
    for (const double off : {0., 1e-16, 1e-12, 1e-9, 1e-6})
      for (const double side : {-1., 1.})
        places.push_back(side * (x + off));
  for (const Source<dim> &source : all_sources<dim>())
    {
      double largest = 0., steepest = 0.;
      bool finite = true;
      for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t j = 0; j < places.size(); ++j)
          for (std::size_t k = 0; k < (dim == 3 ? places.size() : 1); k += 3)
            {
              Vector<dim> x;
              x[0]       = places[i];
              x[1]       = places[j];
              x[dim - 1] = dim == 3 ? places[k] : places[j];
              if (source.name == "mesh" && (i % 5 != 0 || j % 3 != 0))
                continue;
              const double H = norm(source.field->field(source.amplitude, x));
              const double G = frobenius_norm(source.field->field_gradient(source.amplitude, x));
              finite         = finite && std::isfinite(H) && std::isfinite(G);
              largest        = std::max(largest, H);
              steepest       = std::max(steepest, G);
            }
      INFO(source.name);
      CHECK(finite);
      const double size = is_current(source.name) ? 1e3 / (2. * pi * 0.05) : 1e6;
      CHECK(largest < 8. * size);
      CHECK(largest > 0.1 * size);
      CHECK(steepest < 1e5 * size);
    }
}
