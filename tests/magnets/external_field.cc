#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/magnets/external_field.h>
#include <magmpm/magnets/make_source.h>

#include "catch.h"
#include "source_texts.h"

#include <cmath>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  template <int dim>
  Vector<dim>
  magnetization_of_sphere()
  {
    if constexpr (dim == 3)
      return {{3e5, -1e6, 2e6}};
    else
      return {{3e5, -1e6}};
  }

  template <int dim>
  Vector<dim>
  centre_of_sphere()
  {
    if constexpr (dim == 3)
      return {{0.1, -0.2, 0.3}};
    else
      return {{0.1, -0.2}};
  }

  template <int dim>
  SourceParameters<dim>
  sphere_parameters(const TimeFunction<Vector<dim>> &magnetization = magnetization_of_sphere<dim>(),
                    const double radius                            = 0.05)
  {
    SourceParameters<dim> parameters;
    parameters.name     = "ball";
    parameters.kind     = MagnetizedSphereParameters<dim>{magnetization, radius};
    parameters.pose     = Pose<dim>{centre_of_sphere<dim>()};
    parameters.is_solid = true;
    return parameters;
  }

  template <int dim>
  SourceParameters<dim>
  uniform_parameters(const std::string &field = dim == 3 ? "1e4; 2e4; -3e4" : "1e4; 2e4")
  {
    SourceParameters<dim> parameters;
    parameters.name = "coil";
    parameters.kind = UniformFieldParameters<dim>{vector<dim>(field)};
    return parameters;
  }

  /** Unit vectors all around. */
  template <int dim>
  std::vector<Vector<dim>>
  directions()
  {
    std::vector<Vector<dim>> result;
    for (int i = 0; i < 24; ++i)
      {
        const double phi = 0.1 + i * constants::pi / 12.;
        if constexpr (dim == 2)
          result.push_back({{std::cos(phi), std::sin(phi)}});
        else
          for (double z = -0.95; z < 1.; z += 0.19)
            {
              const double rho = std::sqrt(1. - z * z);
              result.push_back({{rho * std::cos(phi), rho * std::sin(phi), z}});
            }
      }
    return result;
  }

  /** The gradient of a source by central differences; G(i,j) = dH_i/dx_j. */
  template <int dim>
  Matrix<dim>
  difference_gradient(const MagneticSource<dim> &source,
                      const Vector<dim> &point,
                      const double step)
  {
    Matrix<dim> gradient;
    for (int j = 0; j < dim; ++j)
      {
        Vector<dim> before = point, after = point;
        before[j] -= step;
        after[j] += step;
        const Vector<dim> slope = (1. / (2. * step)) * (source.field(after) - source.field(before));
        for (int i = 0; i < dim; ++i)
          gradient(i, j) = slope[i];
      }
    return gradient;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("outside of a magnetized sphere the field has no divergence and no curl",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The trace and the antisymmetric part of the gradient vanish in empty space (Maxwell), and the
  // gradient is the difference quotient of the field: with a step of 1e-4 distances, error 1e-7.
  const auto sphere = make_source(sphere_parameters<dim>());
  for (const double distance : {0.0501, 0.08, 0.5, 3.})
    for (const Vector<dim> &n : directions<dim>())
      {
        const Vector<dim> point    = centre_of_sphere<dim>() + distance * n;
        const Matrix<dim> gradient = sphere->field_gradient(point);
        const double size          = frobenius_norm(gradient);
        CHECK(std::abs(trace(gradient)) < 1e-14 * size);
        CHECK(frobenius_norm(gradient + (-1.) * transpose(gradient)) < 1e-14 * size);
        const Matrix<dim> difference = difference_gradient(*sphere, point, 1e-4 * distance);
        CHECK(frobenius_norm(gradient + (-1.) * difference) < 2e-7 * size);
      }
}

TEMPLATE_TEST_CASE_SIG("at the surface of a magnetized sphere normal B and tangential H go through",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Just inside B = mu0 (H + M), outside B = mu0 H: n.(H + M) inside is n.H outside, and the rest
  // of H is the same. Points 1e-9 m off the surface leave about 1e-7 of M.
  const auto sphere   = make_source(sphere_parameters<dim>());
  const Vector<dim> m = magnetization_of_sphere<dim>();
  for (const Vector<dim> &n : directions<dim>())
    {
      const Vector<dim> inside  = sphere->field(centre_of_sphere<dim>() + (0.05 - 1e-9) * n);
      const Vector<dim> outside = sphere->field(centre_of_sphere<dim>() + (0.05 + 1e-9) * n);
      const Vector<dim> jump    = outside - inside;
      CHECK(norm(jump - dot(m, n) * n) < 2e-7 * norm(m));
    }
}

TEMPLATE_TEST_CASE_SIG("inside of a magnetized sphere the field is -M/3, of a cylinder -M/2",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  // The demagnetizing factor of a sphere is 1/3 and of a cylinder across its axis 1/2; the field is
  // uniform, so its gradient is zero. At a point exactly on the surface, the outside counts: at the
  // pole, H = (dim-1)/dim M, which is the strength.
  SourceParameters<dim> parameters =
    sphere_parameters<dim>(vector<dim>(dim == 3 ? "0; 2e6; 0" : "0; 2e6"), 0.5);
  parameters.pose   = Pose<dim>();
  const auto sphere = make_source(parameters);

  Vector<dim> point;
  CHECK(sphere->field(point)[1] == Approx(-2e6 / dim));
  CHECK(frobenius_norm(sphere->field_gradient(point)) == 0.);
  point[0] = 0.499;
  CHECK(sphere->field(point)[1] == Approx(-2e6 / dim));
  CHECK(sphere->field(point)[0] == 0.);

  Vector<dim> pole;
  pole[1] = 0.5;
  CHECK(sphere->field(pole)[1] == Approx(2e6 * (dim - 1) / dim));
  CHECK(norm(sphere->strength()) == Approx(norm(sphere->field(pole))));
}

TEST_CASE("far away a magnetized sphere is a dipole", "[magnets]")
{
  // H = (3 (m.n) n - m)/(4 pi r^3) of the moment m = 4/3 pi R^3 M, in 2D
  // (2 (m.n) n - m)/(2 pi r^2) of the moment per length pi R^2 M: textbook formulas.
  const auto sphere  = make_source(sphere_parameters<3>());
  const Vector<3> m3 = (4. / 3. * constants::pi * 1.25e-4) * magnetization_of_sphere<3>();
  for (const Vector<3> &n : directions<3>())
    {
      const Vector<3> dipole = (1. / (4. * constants::pi * 8.)) * (3. * dot(m3, n) * n - m3);
      CHECK(norm(sphere->field(centre_of_sphere<3>() + 2. * n) - dipole) < 1e-13 * norm(dipole));
    }

  const auto cylinder = make_source(sphere_parameters<2>());
  const Vector<2> m2  = (constants::pi * 2.5e-3) * magnetization_of_sphere<2>();
  for (const Vector<2> &n : directions<2>())
    {
      const Vector<2> dipole = (1. / (2. * constants::pi * 4.)) * (2. * dot(m2, n) * n - m2);
      CHECK(norm(cylinder->field(centre_of_sphere<2>() + 2. * n) - dipole) < 1e-13 * norm(dipole));
    }
}

TEMPLATE_TEST_CASE_SIG("the external field is the sum of its sources",
                       "[magnets]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Two spheres and a uniform field: field and gradient must be those of the three added up, which
  // the sources give one by one; the uniform one adds its value and no gradient.
  SourceParameters<dim> other = sphere_parameters<dim>();
  other.name                  = "other";
  other.pose                  = at<dim>(dim == 3 ? "1; 1; 1" : "1; 1");
  other.is_solid              = false;
  const ExternalField<dim> field({sphere_parameters<dim>(), uniform_parameters<dim>(), other});
  const auto first   = make_source(sphere_parameters<dim>());
  const auto last    = make_source(other);
  const auto uniform = make_source(uniform_parameters<dim>());

  const Vector<dim> point = 0.4 * identity<dim>() * magnetization_of_sphere<dim>();
  const Vector<dim> near  = centre_of_sphere<dim>() + 0.06 * directions<dim>()[3];
  for (const Vector<dim> &x : {point, near, centre_of_sphere<dim>()})
    {
      const Vector<dim> sum = first->field(x) + uniform->field(x) + last->field(x);
      CHECK(norm(field.field(x) - sum) <= 1e-15 * norm(sum));
      const Matrix<dim> gradient = first->field_gradient(x) + last->field_gradient(x);
      CHECK(frobenius_norm(field.field_gradient(x) + (-1.) * gradient) <=
            1e-15 * frobenius_norm(gradient));
    }
  CHECK(uniform->field(near)[0] == 1e4);
  CHECK(uniform->field(near)[1] == 2e4);
  CHECK(frobenius_norm(uniform->field_gradient(near)) == 0.);

  // Only the first sphere has a surface.
  CHECK(field.sources().size() == 3);
  CHECK(field.sources()[1]->name() == "coil");
  REQUIRE(field.solid_sources().size() == 1);
  CHECK(field.solid_sources()[0]->name() == "ball");
  CHECK(field.solid_sources()[0]->is_solid());
  CHECK(!field.sources()[2]->is_solid());
  CHECK(field.solid_sources()[0]->shape()->bounding_box().upper[0] == 0.05);
}

TEST_CASE("a moving magnet takes its field along and knows its velocity", "[magnets]")
{
  // A sphere on the line x = 0.1 + 2 t: at t = 0.25 s its field is that of a sphere at rest at 0.6,
  // and its velocity is 2 m/s.
  SourceParameters<3> moving  = sphere_parameters<3>();
  moving.pose                 = at<3>("0.1 + 2*t; -0.2; 0.3");
  SourceParameters<3> at_rest = sphere_parameters<3>();
  at_rest.pose                = at<3>("0.6; -0.2; 0.3");

  ExternalField<3> field({moving});
  const ExternalField<3> expected({at_rest});
  CHECK(field.solid_sources()[0]->pose().position[0] == Approx(0.1));
  field.set_time(0.25);
  CHECK(field.solid_sources()[0]->pose().position[0] == Approx(0.6));
  CHECK(motion_at(moving.pose, 0.25).velocity[0] == Approx(2.).epsilon(1e-9));
  CHECK(norm(motion_at(at_rest.pose, 0.25).velocity) == 0.);
  const Vector<3> point = {{0.5, 0., 0.4}};
  CHECK(norm(field.field(point) - expected.field(point)) < 1e-14 * norm(expected.field(point)));
  CHECK(!field.is_constant());
  CHECK(expected.is_constant());
}

TEST_CASE("an external field knows how much it changed since it was remembered", "[magnets]")
{
  // A field that grows by 1 % a second, and a magnet that moves 3 m/s and 4 m/s: after half a
  // second 0.005/1.005 of the strength, 2.5 m. What was never remembered changed without bounds.
  const SourceParameters<2> growing = uniform_parameters<2>("1e4*(1 + 0.01*t); 0");
  SourceParameters<2> moving        = sphere_parameters<2>();
  moving.pose                       = at<2>("3*t; 1 - 4*t");
  ExternalField<2> field({growing, moving});
  CHECK(std::isinf(field.change_since_remembered().relative_strength));
  CHECK(std::isinf(field.change_since_remembered().displacement));

  field.remember();
  CHECK(field.change_since_remembered().relative_strength == 0.);
  CHECK(field.change_since_remembered().displacement == 0.);
  field.set_time(0.5);
  CHECK(field.change_since_remembered().relative_strength == Approx(0.005 / 1.005));
  CHECK(field.change_since_remembered().displacement == Approx(2.5));
  field.set_time(0.);
  CHECK(field.change_since_remembered().displacement == 0.);

  // A field that turns round at the same strength changes by twice itself, one switched on by all.
  ExternalField<2> turned({uniform_parameters<2>("1e4*cos(pi*t); 1e4*sin(pi*t)")});
  turned.remember();
  turned.set_time(1.);
  CHECK(turned.change_since_remembered().relative_strength == Approx(2.));
  ExternalField<2> started({uniform_parameters<2>("0; t")});
  started.remember();
  started.set_time(1e-9);
  CHECK(started.change_since_remembered().relative_strength == 1.);
}

TEST_CASE("without sources, or with such that are zero for ever, there is no field", "[magnets]")
{
  // A mere obstacle, a sphere without magnetization that moves, makes no field and never changes;
  // a field that is zero now and grows later is one.
  CHECK(ExternalField<3>({}).is_absent());
  CHECK(ExternalField<3>({}).is_constant());
  CHECK(norm(ExternalField<3>({}).field({{1., 2., 3.}})) == 0.);

  SourceParameters<3> obstacle = sphere_parameters<3>(Vector<3>());
  obstacle.pose                = at<3>("t; 0; 0");
  ExternalField<3> obstructed({obstacle});
  obstructed.remember();
  obstructed.set_time(1.);
  CHECK(obstructed.is_absent());
  CHECK(obstructed.is_constant());
  CHECK(obstructed.change_since_remembered().displacement == 0.);
  CHECK(obstructed.solid_sources().size() == 1);

  CHECK(!ExternalField<3>({uniform_parameters<3>("0; 0; 1e5*t")}).is_absent());
  CHECK(!ExternalField<3>({sphere_parameters<3>()}).is_absent());
}

TEST_CASE("sources that make no sense are refused by name", "[magnets]")
{
  // The wording, which users meet.
  CHECK_THROWS_WITH(ExternalField<3>({sphere_parameters<3>(Vector<3>(), -0.1)}),
                    "The radius of the magnetized sphere 'ball' is -0.1 m. Give a positive one.");

  SourceParameters<3> solid_field = uniform_parameters<3>();
  solid_field.is_solid            = true;
  CHECK_THROWS_WITH(ExternalField<3>({solid_field}),
                    "Source 'coil' is a uniform field, which has no surface, but has a contact "
                    "condition. Set it to none.");
  CHECK_THROWS_AS(ExternalField<3>({solid_field}), InputError);
}

TEST_CASE("the revision of a source tells whether it has changed", "[magnets]")
{
  // One that stays as it is keeps its number, whatever the time; another position, rotation or strength
  // gives another one. What is put where it is already has not changed.
  SourceParameters<3> steady = sphere_parameters<3>(), moving = steady, turning = steady,
                      growing = steady;
  moving.pose                 = at<3>("t; 0; 0");
  turning.pose                = at<3>("0; 0; 0", "0; 0; t");
  growing.strength            = number("1 + t");
  ExternalField<3> field({steady, moving, turning, growing, uniform_parameters<3>("0; 0; t")});
  const auto revisions = [&] {
    std::vector<unsigned long> result;
    for (const auto *source : field.sources())
      result.push_back(source->revision());
    return result;
  };
  const auto at_start = revisions();
  field.set_time(0.);
  CHECK(revisions() == at_start);
  field.set_time(1.);
  const auto later = revisions();
  CHECK(later[0] == at_start[0]);
  for (int s = 1; s < 5; ++s)
    CHECK(later[s] != at_start[s]);
  field.set_time(1.);
  CHECK(revisions() == later);

  field.set_pose(0, field.sources()[0]->pose());
  CHECK(revisions() == later);
  field.set_pose(0, Pose<3>{{{0., 1e-9, 0.}}});
  CHECK(revisions()[0] != later[0]);
}
