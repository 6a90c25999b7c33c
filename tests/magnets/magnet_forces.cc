// Force and torque of magnets on each other: against exact formulas, and the third law, for which two
// different rules of integration must agree.

#include <magmpm/base/constants.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/magnets/magnetized_mesh.h>

#include "field_checks.h"
#include "geometry/test_meshes.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  constexpr double pi = constants::pi, mu_0 = constants::vacuum_permeability;

  template <int dim>
  SourceParameters<dim>
  source(const SourceType type, const std::string &name)
  {
    SourceParameters<dim> parameters;
    parameters.type             = type;
    parameters.name             = name;
    parameters.radius           = 0.02;
    parameters.length           = 0.05;
    parameters.conductor_radius = 0.001;
    for (int d = 0; d < dim; ++d)
      parameters.size[d] = 0.03 + 0.01 * d;
    parameters.magnetization = dim == 3 ? "3e5; -5e5; 8e5" : "3e5; -5e5";
    parameters.moment        = dim == 3 ? "3; -5; 8" : "30; -50";
    parameters.current       = "2e4";
    parameters.position      = dim == 3 ? "0; 0; 0" : "0; 0";
    return parameters;
  }

  /** Force and torque about the origin on both of two sources, and how much they fail to cancel. */
  template <int dim>
  double
  imbalance(const SourceParameters<dim> &a, const SourceParameters<dim> &b)
  {
    const ExternalField<dim> field({a, b});
    Vector<dim> force;
    Vector<n_axial_components<dim>> torque;
    double size = 0.;
    for (const auto &source : field.sources())
      {
        const auto action = field.force_and_torque(*source);
        REQUIRE(action);
        force += action->force;
        torque += action->torque + cross(source->pose().position, action->force);
        size = std::max(size, norm(action->force));
      }
    REQUIRE(size > 0.);
    return (norm(force) + norm(torque) / 0.1) / size;
  }
} // namespace

TEST_CASE("the force between two dipoles is the known one", "[magnets]")
{
  // F on the second one, r from the first to it, distance r, n = r/r (Yung et al., Magn. Electr. Sep. 9,
  // 39 (1998)): 3 mu_0/(4 pi r^4) [(m1.n) m2 + (m2.n) m1 + (m1.m2) n - 5 (m1.n)(m2.n) n], and the
  // torque mu_0 m2 x H1. One of them is turned by its rotation.
  SourceParameters<3> first = source<3>(SourceType::point_dipole, "first"), second = first;
  second.name     = "second";
  second.moment   = "0; 0; 4";
  second.rotation = "pi/2; 0; 0"; // z to -y
  second.position = "0.2; 0.1; -0.1";
  const ExternalField<3> field({first, second});
  const Vector<3> m1 = {{3., -5., 8.}}, m2 = {{0., -4., 0.}}, r = {{0.2, 0.1, -0.1}};
  const double distance = norm(r);
  const Vector<3> n     = (1. / distance) * r;
  const Vector<3> force =
    (3. * mu_0 / (4. * pi * std::pow(distance, 4))) *
    (dot(m1, n) * m2 + dot(m2, n) * m1 + dot(m1, m2) * n - (5. * dot(m1, n) * dot(m2, n)) * n);
  const auto action = field.force_and_torque(*field.sources()[1]);
  REQUIRE(action);
  CHECK(norm(action->force - force) < 1e-12 * norm(force));
  const Vector<3> torque = mu_0 * cross(m2, dipole_field(m1, r));
  CHECK(norm(action->torque - torque) < 1e-12 * norm(torque));

  // A sphere acts and is acted on as the dipole of its moment.
  SourceParameters<3> sphere = source<3>(SourceType::magnetized_sphere, "second");
  sphere.position            = second.position;
  sphere.magnetization       = "0; 0; " + std::to_string(4. / (4. / 3. * pi * 8e-6));
  sphere.rotation            = second.rotation;
  const ExternalField<3> other({first, sphere});
  CHECK(norm(other.force_and_torque(*other.sources()[1])->force - force) < 1e-7 * norm(force));
}

TEST_CASE("a uniform field turns a magnet and does not push it", "[magnets]")
{
  // T = mu_0 m x H and F = 0, for each kind: also for a loop, m = I pi R^2 along its axis. The field
  // itself has no place, and nothing acts on it.
  SourceParameters<3> uniform = source<3>(SourceType::uniform_field, "coil");
  uniform.field               = "1e5; 2e5; -3e5";
  const Vector<3> H = {{1e5, 2e5, -3e5}}, m = {{3e5, -5e5, 8e5}};
  const struct
  {
    SourceType type;
    Vector<3> moment;
  } kinds[] = {{SourceType::magnetized_sphere, 4. / 3. * pi * 8e-6 * m},
               {SourceType::cuboid, 0.03 * 0.04 * 0.05 * m},
               {SourceType::cylinder, pi * 4e-4 * 0.05 * m},
               {SourceType::point_dipole, {{3., -5., 8.}}},
               {SourceType::current_loop, {{0., 0., 2e4 * pi * 4e-4}}}};
  for (const auto &kind : kinds)
    {
      SourceParameters<3> magnet = source<3>(kind.type, "magnet");
      magnet.position            = "0.3; 0.1; 0.7";
      magnet.rotation            = "0; 0; pi/2";
      const ExternalField<3> field({uniform, magnet});
      CHECK(!field.force_and_torque(*field.sources()[0]));
      const auto action = field.force_and_torque(*field.sources()[1]);
      REQUIRE(action);
      const Vector<3> turned = {{-kind.moment[1], kind.moment[0], kind.moment[2]}};
      const Vector<3> torque = mu_0 * cross(turned, H);
      CHECK(norm(action->torque - torque) < 1e-11 * norm(torque));
      CHECK(norm(action->force) < 1e-9 * norm(torque) / 0.02);
    }
}

TEST_CASE("magnets of different kinds obey the third law, torque included", "[magnets]")
{
  // The force and the torque about one point on either of two magnets are opposite. Each is a sum over
  // the points of one magnet of the exact field of the other, so both rules must be right. The margins
  // are those of 5 Gauss points at a gap of about a magnet's size.
  SourceParameters<3> cuboid       = source<3>(SourceType::cuboid, "cuboid");
  cuboid.position                  = "0.02; 0.07; 0.03";
  cuboid.rotation                  = "0.5; -0.7; 0.3";
  SourceParameters<3> cylinder     = source<3>(SourceType::cylinder, "cylinder");
  cylinder.axis                    = {{1., 1., 0.}};
  const SourceParameters<3> loop   = source<3>(SourceType::current_loop, "loop");
  const SourceParameters<3> dipole = source<3>(SourceType::point_dipole, "dipole");
  CHECK(imbalance(cylinder, cuboid) < 1e-4);
  CHECK(imbalance(loop, cuboid) < 1e-4);
  CHECK(imbalance(dipole, cuboid) < 1e-4);

  SourceParameters<3> second_loop = loop;
  second_loop.name                = "second";
  second_loop.position            = "0.01; 0.03; 0.03";
  second_loop.axis                = {{1., 0., 2.}};
  CHECK(imbalance(loop, second_loop) < 1e-8);

  SourceParameters<2> rectangle = source<2>(SourceType::cuboid, "rectangle");
  rectangle.position            = "0.02; 0.07";
  rectangle.rotation            = "0.4";
  CHECK(imbalance(rectangle, source<2>(SourceType::magnetized_sphere, "sphere")) < 1e-4);
  CHECK(imbalance(rectangle, source<2>(SourceType::straight_wire, "wire")) < 1e-4);
}

TEST_CASE("parallel wires attract, and one without ends has no force in space", "[magnets]")
{
  // mu_0 I1 I2/(2 pi d) per metre, towards each other for the same direction (Ampere).
  SourceParameters<2> first = source<2>(SourceType::straight_wire, "first"), second = first;
  second.name     = "second";
  second.position = "0.1; 0";
  const ExternalField<2> pair({first, second});
  const auto action = pair.force_and_torque(*pair.sources()[1]);
  CHECK(action->force[0] == Approx(-mu_0 * 4e8 / (2. * pi * 0.1)).epsilon(1e-13));
  CHECK(std::abs(action->force[1]) < 1e-12 * std::abs(action->force[0]));

  SourceParameters<3> endless = source<3>(SourceType::straight_wire, "endless");
  endless.length              = 0.;
  SourceParameters<3> piece   = source<3>(SourceType::straight_wire, "piece");
  piece.position              = "0.1; 0; 0";
  const ExternalField<3> spatial({endless, piece});
  CHECK(!spatial.force_and_torque(*spatial.sources()[0]));
  CHECK(spatial.force_and_torque(*spatial.sources()[1])->force[0] ==
        Approx(-mu_0 * 4e8 / (2. * pi * 0.1) * 0.05).epsilon(1e-13));
}

TEST_CASE("the force on a mesh is that on the cuboid that it is", "[magnets]")
{
  // A grid of points against Gauss points, in the field of a dipole: equal but for the square of the
  // grid's spacing, and in a uniform gradient exactly.
  const Vector<3> m = 1e6 * oblique<3>();
  const MagnetizedMesh mesh(box_mesh({{-0.01, -0.02, 0.}}, {{0.02, 0.02, 0.05}}));
  const Matrix<3> gradient = {{{1e6, 2e6, 0.}, {2e6, -3e6, 1e6}, {0., 1e6, 2e6}}};
  const auto linear        = mesh.force_and_torque(m, [&](const Vector<3> &x) {
    return LocalField<3>{gradient * x, gradient};
  });
  const double volume      = 0.03 * 0.04 * 0.05;
  const Vector<3> centroid = {{0.005, 0., 0.025}}, force = (mu_0 * volume) * (gradient * m);
  CHECK(norm(linear->force - force) < 1e-12 * norm(force));
  const Vector<3> torque = cross(centroid, force) + (mu_0 * volume) * cross(m, gradient * centroid);
  CHECK(norm(linear->torque - torque) < 1e-12 * norm(torque));

  // T = int x x (M.grad)H + M x H has a quadratic part only through H being quadratic.
  const auto quadratic = mesh.force_and_torque(m, [&](const Vector<3> &x) {
    return LocalField<3>{{{x[0] * x[0], 0., 0.}}, {{{2. * x[0], 0., 0.}, {}, {}}}};
  });
  CHECK(quadratic->force[0] == Approx(mu_0 * volume * 2. * 0.005 * m[0]).epsilon(1e-12));
}

TEST_CASE("a mesh that is not convex has its elements inside", "[magnets]")
{
  // In the field H = x e_x the force is mu_0 V M_x whatever the shape, and the elements of a sphere
  // lie within its radius: with H = x^2 e_x only their centroid counts, with x^3 their spread,
  // int x^2 = V R^2/5, 3 mu_0 M_x of it. A grid of 12 leaves 2 %.
  const MagnetizedMesh sphere(sphere_mesh(24));
  const auto cubic = sphere.force_and_torque({{1., 0., 0.}}, [&](const Vector<3> &x) {
    return LocalField<3>{{{std::pow(x[0], 3), 0., 0.}}, {{{3. * x[0] * x[0], 0., 0.}, {}, {}}}};
  });
  CHECK(cubic->force[0] == Approx(3. * mu_0 * 4. / 3. * pi / 5.).epsilon(0.03));
}
