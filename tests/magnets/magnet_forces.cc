// Force and torque of magnets on each other: against exact formulas, and the third law, for which two
// different rules of integration must agree.

#include <magmpm/base/constants.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/magnets/magnetized_mesh.h>

#include "field_checks.h"
#include "geometry/test_meshes.h"
#include "source_texts.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  constexpr double pi = constants::pi, mu_0 = constants::vacuum_permeability;

  template <int dim>
  TimeFunction<Vector<dim>>
  magnetization()
  {
    return vector<dim>(dim == 3 ? "3e5; -5e5; 8e5" : "3e5; -5e5");
  }

  template <int dim>
  PointDipoleParameters<dim>
  point_dipole()
  {
    return {vector<dim>(dim == 3 ? "3; -5; 8" : "30; -50"), 0.02};
  }

  template <int dim>
  MagnetizedSphereParameters<dim>
  sphere()
  {
    return {magnetization<dim>(), 0.02};
  }

  template <int dim>
  CuboidParameters<dim>
  cuboid()
  {
    CuboidParameters<dim> parameters = {magnetization<dim>(), {}};
    for (int d = 0; d < dim; ++d)
      parameters.size[d] = 0.03 + 0.01 * d;
    return parameters;
  }

  CylinderParameters
  cylinder(const Vector<3> &axis = {})
  {
    return {magnetization<3>(), 0.02, 0.05, axis};
  }

  CurrentLoopParameters
  loop(const Vector<3> &axis = {})
  {
    return {2e4, 0.02, 0.001, axis};
  }

  template <int dim>
  StraightWireParameters<dim>
  wire(const double length)
  {
    return {2e4, 0.001, length, {}};
  }

  template <int dim>
  SourceParameters<dim>
  source(const SourceKind<dim> &kind, const std::string &name)
  {
    SourceParameters<dim> parameters;
    parameters.name = name;
    parameters.kind = kind;
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
  const SourceParameters<3> first = source<3>(point_dipole<3>(), "first");
  SourceParameters<3> second      = source<3>(PointDipoleParameters<3>{vector<3>("0; 0; 4"), 0.02},
                                         "second");
  second.pose                     = at<3>("0.2; 0.1; -0.1", "pi/2; 0; 0"); // z to -y
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
  const Vector<3> of_moment = {{0., 0., 4. / (4. / 3. * pi * 8e-6)}};
  SourceParameters<3> ball  = source<3>(MagnetizedSphereParameters<3>{of_moment, 0.02}, "second");
  ball.pose                 = second.pose;
  const ExternalField<3> other({first, ball});
  CHECK(norm(other.force_and_torque(*other.sources()[1])->force - force) < 1e-7 * norm(force));
}

TEST_CASE("a uniform field turns a magnet and does not push it", "[magnets]")
{
  // T = mu_0 m x H and F = 0, for each kind: also for a loop, m = I pi R^2 along its axis. The field
  // itself has no place, and nothing acts on it.
  const Vector<3> H = {{1e5, 2e5, -3e5}}, m = {{3e5, -5e5, 8e5}};
  const SourceParameters<3> uniform = source<3>(UniformFieldParameters<3>{H}, "coil");
  const struct
  {
    SourceKind<3> parameters;
    Vector<3> moment;
  } kinds[] = {{sphere<3>(), 4. / 3. * pi * 8e-6 * m},
               {cuboid<3>(), 0.03 * 0.04 * 0.05 * m},
               {cylinder(), pi * 4e-4 * 0.05 * m},
               {point_dipole<3>(), {{3., -5., 8.}}},
               {loop(), {{0., 0., 2e4 * pi * 4e-4}}}};
  for (const auto &kind : kinds)
    {
      SourceParameters<3> magnet = source<3>(kind.parameters, "magnet");
      magnet.pose                = at<3>("0.3; 0.1; 0.7", "0; 0; pi/2");
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
  SourceParameters<3> bar          = source<3>(cuboid<3>(), "cuboid");
  bar.pose                         = at<3>("0.02; 0.07; 0.03", "0.5; -0.7; 0.3");
  const SourceParameters<3> rod    = source<3>(cylinder({{1., 1., 0.}}), "cylinder");
  const SourceParameters<3> coil   = source<3>(loop(), "loop");
  const SourceParameters<3> dipole = source<3>(point_dipole<3>(), "dipole");
  CHECK(imbalance(rod, bar) < 1e-4);
  CHECK(imbalance(coil, bar) < 1e-4);
  CHECK(imbalance(dipole, bar) < 1e-4);

  SourceParameters<3> second_coil = source<3>(loop({{1., 0., 2.}}), "second");
  second_coil.pose                = at<3>("0.01; 0.03; 0.03");
  CHECK(imbalance(coil, second_coil) < 1e-8);

  SourceParameters<2> rectangle = source<2>(cuboid<2>(), "rectangle");
  rectangle.pose                = at<2>("0.02; 0.07", "0.4");
  CHECK(imbalance(rectangle, source<2>(sphere<2>(), "sphere")) < 1e-4);
  CHECK(imbalance(rectangle, source<2>(wire<2>(0.), "wire")) < 1e-4);
}

TEST_CASE("parallel wires attract, and one without ends has no force in space", "[magnets]")
{
  // mu_0 I1 I2/(2 pi d) per metre, towards each other for the same direction (Ampere).
  const SourceParameters<2> first = source<2>(wire<2>(0.), "first");
  SourceParameters<2> second      = source<2>(wire<2>(0.), "second");
  second.pose                     = at<2>("0.1; 0");
  const ExternalField<2> pair({first, second});
  const auto action = pair.force_and_torque(*pair.sources()[1]);
  CHECK(action->force[0] == Approx(-mu_0 * 4e8 / (2. * pi * 0.1)).epsilon(1e-13));
  CHECK(std::abs(action->force[1]) < 1e-12 * std::abs(action->force[0]));

  const SourceParameters<3> endless = source<3>(wire<3>(0.), "endless");
  SourceParameters<3> piece         = source<3>(wire<3>(0.05), "piece");
  piece.pose                        = at<3>("0.1; 0; 0");
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
