#include <magmpm/boundary/contact_law.h>

#include "catch.h"

using namespace magmpm;

namespace
{
  /** A half space of the density 1000 kg/m^3 that fills all above y = gap, at a node at the height @p height. */
  NodeSolid<2>
  half_space(const double height, const double spacing)
  {
    const double q = height / spacing;
    return {1000. * spacing * spacing * spline_integral(q),
            1000.,
            1e6,
            {{0., -spacing * spline_of_distance(q)}}};
  }

  NodeSurface<2>
  floor_at(const double height, const double gap)
  {
    return {height, {{0., 1.}}, gap, {}, {ContactCondition::separate, 0.3}};
  }
} // namespace

TEST_CASE("The spline of a distance is the derivative of its integral", "[boundary]")
{
  CHECK(spline_integral(-1.5) == 0.);
  CHECK(spline_integral(0.) == Approx(0.5));
  CHECK(spline_integral(1.5) == Approx(1.));
  for (const double q : {-1.7, -1.2, -0.5, -0.2, 0.3, 0.9, 1.6})
    CHECK((spline_integral(q + 1e-5) - spline_integral(q - 1e-5)) / 2e-5 ==
          Approx(spline_of_distance(q)).margin(1e-5));
}

TEST_CASE("The areas of the nodes of a face sum to its area", "[boundary]")
{
  // Wherever the face lies on the lattice: per metre of depth a node stands for one dx of a face.
  const double spacing = 0.1;
  for (const double offset : {0., 0.13, 0.31, 0.5, 0.77})
    {
      double sum = 0.;
      for (int i = -3; i <= 3; ++i)
        {
          const double height = (i + offset) * spacing;
          sum += contact_area(half_space(height, spacing), floor_at(height, 0.), spacing);
        }
      CHECK(sum == Approx(spacing).epsilon(1e-12));
    }
}

TEST_CASE("The pressure of contact has its energy", "[boundary]")
{
  for (const double depth : {0.01, 0.3, 0.8, 0.95, 1.3})
    CHECK((contact_energy(depth + 1e-6) - contact_energy(depth - 1e-6)) / 2e-6 ==
          Approx(contact_pressure(depth)).epsilon(1e-6));
  CHECK(contact_pressure(0.1) == Approx(0.1 / 0.9));
}

TEST_CASE("Contact pushes where there is no gap, and will be none", "[boundary]")
{
  const double spacing = 0.1, time_step = 1e-3;
  const NodeSolid<2> solid = half_space(0., spacing);
  const auto pressing      = [&](const double gap, const double approach) {
    return pressing_impulse(solid, floor_at(0., gap), spacing, time_step, approach);
  };
  CHECK(pressing(0.001, -10.) == 0.);
  CHECK(pressing(-0.01, 11.) == 0.);
  // Half of the face is this node's to three quarters: A = 0.75 dx; p = M/9 at a tenth of a cell.
  CHECK(pressing(-0.01, -1.) == Approx(1e-3 * 0.075 * 1e6 / 9.));
}

TEST_CASE("Friction takes what Coulomb's law allows", "[boundary]")
{
  const SurfaceContact slides = {ContactCondition::separate, 0.3};
  const Vector<2> normal = {{0., 1.}}, relative = {{2., -1.}};
  // Of a node of 5 kg that slides at 2 m/s: 10 N s.
  CHECK(friction_share(slides, 5., 10., normal, relative).tangential == Approx(0.3));
  CHECK(friction_share(slides, 5., 100., normal, relative).tangential == 1.);
  CHECK(friction_share(slides, 5., 0., normal, relative).tangential == 0.);
  CHECK(friction_share({ContactCondition::separate, 0.}, 5., 10., normal, relative).tangential ==
        0.);
  CHECK(friction_share({ContactCondition::stick, 0.}, 5., 1e-3, normal, relative).tangential == 1.);
  CHECK(friction_share({ContactCondition::stick, 0.}, 5., 0., normal, relative).tangential == 0.);
  CHECK(friction_share(slides, 5., 10., normal, relative).normal == 0.);
}
