// Sources in their places: turned, moved by scripts, key frames or from outside, solid or not.

#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/cuboid.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/magnets/make_source.h>
#include <magmpm/motion/key_frames.h>

#include "field_checks.h"
#include "source_texts.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  SourceParameters<3>
  cuboid_parameters(const std::string &magnetization = "3e5; -5e5; 8e5")
  {
    SourceParameters<3> parameters;
    parameters.name = "bar";
    parameters.kind = CuboidParameters<3>{vector<3>(magnetization), {{0.2, 0.1, 0.4}}};
    parameters.pose = at<3>("0.5; -0.2; 0.3");
    return parameters;
  }

  SourceParameters<3>
  loop_parameters(const Vector<3> &axis = {})
  {
    SourceParameters<3> parameters;
    parameters.name = "coil";
    parameters.kind = CurrentLoopParameters{100., 0.1, 0.01, axis};
    return parameters;
  }
} // namespace

TEST_CASE("a turned magnet takes its frame along", "[magnets]")
{
  // A quarter turn about z: what is along x of the magnet is along y of the world. Field, gradient,
  // magnetization and shape are those of the magnet at rest, at the point turned back, turned.
  SourceParameters<3> parameters = cuboid_parameters();
  parameters.pose                = at<3>("0.5; -0.2; 0.3", "0; 0; pi/2");
  const auto bar                 = make_source(parameters);
  const Cuboid<3> at_rest(Vector<3>{{0.2, 0.1, 0.4}});
  const Vector<3> m = {{3e5, -5e5, 8e5}}, own = {{0.15, 0.02, 0.07}};
  const Vector<3> world = Vector<3>{{0.5, -0.2, 0.3}} + Vector<3>{{-0.02, 0.15, 0.07}};
  const Vector<3> H     = at_rest.field(m, own);
  CHECK(norm(bar->field(world) - Vector<3>{{-H[1], H[0], H[2]}}) < 1e-9 * norm(H));
  const Matrix<3> G = at_rest.field_gradient(m, own), turned = bar->field_gradient(world);
  CHECK(turned(1, 1) == Approx(G(0, 0)));
  CHECK(turned(0, 1) == Approx(-G(1, 0)));
  CHECK(turned(1, 2) == Approx(G(0, 2)));

  const Vector<3> along_y = {{0.5, -0.11, 0.3}}, along_x = {{0.59, -0.2, 0.3}};
  CHECK(bar->shape()->contains(bar->pose().to_own(along_y)));
  CHECK(!bar->shape()->contains(bar->pose().to_own(along_x)));
  CHECK(norm(bar->magnetization(along_y) - Vector<3>{{5e5, 3e5, 8e5}}) < 1e-9);
  CHECK(norm(bar->magnetization(along_x)) == 0.);
}

TEST_CASE("B goes through the surface of a magnet", "[magnets]")
{
  // mu_0 (H + M) along the normal has no jump: the magnetization is found where the field is that of the
  // inside, for every kind that has one.
  SourceParameters<3> cuboid = cuboid_parameters();
  cuboid.pose                = Pose<3>(); // so that points of the surface are exactly there
  SourceParameters<3> sphere = cuboid, cylinder = cuboid;
  const Vector<3> m = {{3e5, -5e5, 8e5}};
  sphere.kind       = MagnetizedSphereParameters<3>{m, 0.1};
  cylinder.kind     = CylinderParameters{m, 0.1, 0.3, {}};
  for (const SourceParameters<3> &parameters : {cuboid, sphere, cylinder})
    {
      const auto magnet = make_source(parameters);
      const Vector<3> x = magnet->pose().position + Vector<3>{{0.1, 0., 0.}};
      const auto B      = [&](const double off) {
        const Vector<3> point = x + Vector<3>{{off, 0., 0.}};
        return magnet->field(point)[0] + magnet->magnetization(point)[0];
      };
      CHECK(std::abs(B(1e-8) - B(-1e-8)) < 1.);
      CHECK(std::abs(B(1e-8) - B(0.)) < 1.);
      CHECK(magnet->magnetization(x)[0] == 0.);
      CHECK(magnet->magnetization(x - Vector<3>{{1e-8, 0., 0.}})[0] == Approx(3e5));
    }
}

// The magnetization is that of the bar as long as the factor is 1, and nothing where it is 0.
TEST_CASE("the strength of a source is a factor that may change in time", "[magnets]")
{
  SourceParameters<3> parameters = cuboid_parameters("0; 0; 1e6");
  const auto bar                 = make_source(parameters);
  parameters.strength            = number("if(t < 1, 1, 0)");
  const auto other               = make_source(parameters);
  const Vector<3> middle         = bar->pose().position;
  CHECK(other->magnetization(middle)[2] == Approx(1e6));
  CHECK(!other->is_constant());
  other->set_time(2.);
  CHECK(norm(other->field(middle)) == 0.);
}

TEST_CASE("a cylinder, a loop and a wire lie along their axis", "[magnets]")
{
  // A loop about x has its field on the axis along x, I R^2/(2 (R^2 + x^2)^(3/2)); one about -z the
  // opposite one of z. A magnetization is in the source's frame, of which the axis is one direction.
  const Vector<3> H = make_source(loop_parameters({{3., 0., 0.}}))->field({{0.2, 0., 0.}});
  CHECK(H[0] == Approx(100. * 0.01 / (2. * std::pow(0.05, 1.5))));
  CHECK(std::hypot(H[1], H[2]) < 1e-12 * H[0]);
  CHECK(make_source(loop_parameters({{0., 0., -1.}}))->field({{0., 0., 0.2}})[2] == Approx(-H[0]));

  SourceParameters<3> cylinder = cuboid_parameters();
  const Vector<3> x            = {{1., 0., 0.}};
  cylinder.kind                = CylinderParameters{1e6 * x, 0.05, 500., x};
  const auto rod               = make_source(cylinder);
  CHECK(norm(rod->field({{3., -0.2, 0.31}})) < 1.);
  CHECK(rod->magnetization({{3., -0.2, 0.31}})[0] == Approx(1e6));
  CHECK(rod->shape()->contains(rod->pose().to_own({{200., -0.2, 0.3}})));
  CHECK(rod->is_axisymmetric());
}

TEST_CASE("a change of the external field counts rotations", "[magnets]")
{
  // By the angle a the vector of a strength changes by 2 sin(a/2) of itself. A bar that turns about its
  // own magnetization changes its field though that does not; a sphere or a loop about its axis nothing.
  SourceParameters<3> parameters = cuboid_parameters("0; 0; 1e6");
  parameters.pose                = at<3>("0.5; -0.2; 0.3", "0; 0; t");
  const auto change              = [](const SourceParameters<3> &source, const double time) {
    ExternalField<3> field({source});
    field.remember();
    field.set_time(time);
    return field.change_since_remembered();
  };
  CHECK(change(parameters, 0.1).relative_strength == Approx(2. * std::sin(0.05)));
  // The farthest corner, the axis being through the middle: at most its distance from the middle.
  const double reach = norm(Vector<3>{{0.1, 0.05, 0.2}});
  CHECK(change(parameters, 0.1).displacement == Approx(2. * std::sin(0.05) * reach));

  parameters.kind = MagnetizedSphereParameters<3>{Vector<3>{{0., 0., 1e6}}, 0.1};
  CHECK(change(parameters, 0.1).relative_strength < 1e-12);
  CHECK(change(parameters, 0.1).displacement < 1e-12);
  parameters.pose = at<3>("0.5; -0.2; 0.3", "t; 0; 0");
  CHECK(change(parameters, 0.1).relative_strength == Approx(2. * std::sin(0.05)));
  CHECK(change(parameters, 0.1).displacement < 1e-12);

  SourceParameters<3> loop = loop_parameters();
  loop.pose                = at<3>("0; 0; 0", "0; 0; t");
  CHECK(change(loop, 1.).relative_strength < 1e-12);
  loop.pose = at<3>("0; 0; 0", "t; 0; 0");
  CHECK(change(loop, 0.1).displacement == Approx(2. * std::sin(0.05) * 0.1));
}

TEST_CASE("a source put somewhere from outside stays there", "[magnets]")
{
  // From then on its script moves it no more, but still sets its strength, and its field may change.
  SourceParameters<3> parameters = cuboid_parameters();
  CHECK(make_source(parameters)->is_constant());
  parameters.strength = number("1 + t");
  const auto bar      = make_source(parameters);
  Pose<3> pose;
  pose.position = {{1., 2., 3.}};
  bar->set_pose(pose);
  bar->set_time(1.);
  CHECK(bar->pose().position[1] == 2.);
  CHECK(bar->magnetization(pose.position)[0] == Approx(6e5));
  parameters.strength = 1.;
  const auto steady   = make_source(parameters);
  steady->set_pose(pose);
  CHECK(!steady->is_constant());
}

// Two equal poses are no motion, two that differ by 0.1 m are: what is constant is not evaluated
// in each step.
TEST_CASE("key frames that do nothing leave the field constant", "[magnets]")
{
  SourceParameters<3> parameters = cuboid_parameters();
  const auto key_frames          = [](const std::string &table) {
    return read_key_frames<3>(table, KeyFrameInterpolation::linear, "test").pose;
  };
  parameters.pose = key_frames("0, 0.5, -0.2, 0.3; 1, 0.5, -0.2, 0.3");
  CHECK(make_source(parameters)->is_constant());
  parameters.pose = key_frames("0, 0.5, -0.2, 0.3; 1, 0.5, -0.2, 0.4");
  CHECK(!make_source(parameters)->is_constant());
}

TEST_CASE("a solid magnet of any shape keeps material out, a dipole's core refuses it", "[magnets]")
{
  // The turned bar of above, solid: is_solid() by its shape and pose. In the core of a dipole material
  // ends the run, with a message that names the dipole and the place.
  SourceParameters<3> parameters = cuboid_parameters();
  parameters.pose                = at<3>("0.5; -0.2; 0.3", "0; 0; pi/2");
  CHECK(!ExternalField<3>({parameters}).is_solid({{0.5, -0.11, 0.3}}));
  parameters.is_solid = true;
  const ExternalField<3> solid({parameters});
  CHECK(solid.is_solid({{0.5, -0.11, 0.3}}));
  CHECK(!solid.is_solid({{0.59, -0.2, 0.3}}));
  CHECK_NOTHROW(solid.check_material_at({{0.5, -0.2, 0.3}}));

  SourceParameters<3> dipole = cuboid_parameters();
  dipole.name                = "point";
  dipole.kind                = PointDipoleParameters<3>{Vector<3>{{0., 0., 1.}}, 0.01};
  const ExternalField<3> field({dipole});
  CHECK_NOTHROW(field.check_material_at({{0.5, -0.2, 0.311}}));
  CHECK_THROWS_WITH(
    field.check_material_at({{0.5, -0.2, 0.309}}),
    "Magnetic material came to 0.5, -0.2, 0.309 m, inside of the core of the point "
    "dipole 'point', where its field has no meaning. Keep them apart, make its Radius "
    "smaller, or take a magnetized sphere, which may be solid (Contact).");
  CHECK_THROWS_AS(field.check_material_at({{0.5, -0.2, 0.309}}), RunError);
  dipole.is_solid = true;
  CHECK_THROWS_WITH(make_source(dipole),
                    "Source 'point' has no surface, but has a contact condition. Set it to none.");
}
