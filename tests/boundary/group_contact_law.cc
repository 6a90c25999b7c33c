#include <magmpm/boundary/group_contact_law.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  /** One of two half spaces that meet at y = 0, at a node at the height @p height. */
  SharedMaterial<2>
  half_space(const bool is_upper, const double density, const double height, const double spacing)
  {
    const double q      = (is_upper ? 1. : -1.) * height / spacing;
    const double volume = spacing * spacing * spline_integral(q);
    return {density * volume,
            volume,
            1e6,
            {{0., (is_upper ? -1. : 1.) * spacing * spline_of_distance(q)}}};
  }

  /** b above a, both of 2 kg, with a contact area of 0.1 m^2 and 1 MPa. */
  SharedSurface<2>
  surface(const double gap, const SurfaceContact &contact)
  {
    return {{{0., 1.}}, gap, 0.1, 1e6, 1., contact};
  }

  constexpr double spacing = 0.1, time_step = 1e-3;
} // namespace

TEST_CASE("The areas of the nodes that two bodies share sum to that of their face", "[boundary]")
{
  // Wherever the face lies on the lattice and however much denser one is: per metre of depth a node stands for one dx
  // of a face.
  for (const double ratio : {1., 30., 0.01})
    for (const double offset : {0., 0.13, 0.31, 0.5, 0.77})
      {
        double sum = 0.;
        for (int i = -3; i <= 3; ++i)
          {
            const double height = (i + offset) * spacing;
            const auto a        = half_space(false, 1000., height, spacing);
            const auto b        = half_space(true, 1000. * ratio, height, spacing);
            if (a.mass > 0. && b.mass > 0.)
              sum += shared_area(a, b, {{0., 1.}});
          }
        CHECK(sum == Approx(spacing).epsilon(1e-12));
      }
}

TEST_CASE("At a node that a body barely reaches the area is that of its own surface", "[boundary]")
{
  // Over a gap of 0.2 dx the node lies 1.2 dx below a's face and 1.4 dx below b's, whose mass there is a thousandth: what
  // its stress gives to the node must balance, N(1.4) dx, not N(1.2) dx.
  const auto a = half_space(false, 1000., -1.2 * spacing, spacing);
  const auto b = half_space(true, 1000., -1.4 * spacing, spacing);
  CHECK(shared_area(a, b, {{0., 1.}}) == Approx(spacing * spline_of_distance(1.4)).epsilon(0.01));
}

TEST_CASE("Bodies may touch along the normals of both and that between them", "[boundary]")
{
  // a ends upwards, b to the left and downwards in equal parts: out of a is up, into b up and to the right. What has no
  // gradient has no normal.
  const SharedMaterial<2> a = {1., 0.5, 1., {{0., 3.}}}, b = {1., 0.25, 1., {{-2., -2.}}};
  const auto normals = contact_normals(a, b);
  CHECK(norm(normals[0] - Vector<2>{{0., 1.}}) < 1e-15);
  CHECK(norm(normals[1] - std::sqrt(0.5) * Vector<2>{{1., 1.}}) < 1e-15);
  CHECK(norm(normals[2] - 1. / std::sqrt(1. + 1.75 * 1.75) * Vector<2>{{1., 1.75}}) < 1e-15);
  CHECK(norm(contact_normals(a, SharedMaterial<2>{1., 0.25, 1., {}})[1]) == 0.);
}

TEST_CASE(
  "Where sides of two bodies lie in one plane the normal between them is that of their face",
  "[boundary]")
{
  // a to the left of b, both end at the same height, wherever that and the face are from the node: the part of the
  // gradients along the side is the same part of both volumes, and cancels.
  for (const double across : {-0.9, -0.2, 0., 0.4, 1.1})
    for (const double height : {-1.2, -0.3, 0.6})
      {
        const double side = spline_integral(height), slope = spline_of_distance(height);
        const double left = spline_integral(across), right = spline_integral(-across);
        const double face         = spline_of_distance(across);
        const SharedMaterial<2> a = {1., left * side, 1., {{face * side, left * slope}}};
        const SharedMaterial<2> b = {1., right * side, 1., {{-face * side, right * slope}}};
        CHECK(norm(contact_normals(a, b)[2] - Vector<2>{{1., 0.}}) < 1e-12);
      }
}

TEST_CASE("Bodies that separate press by the gap and rub by Coulomb's law", "[boundary]")
{
  // A gap of -0.01 m of 0.1 m presses with p = M 0.1/0.9, over the area and the step: 11.1 N s. Friction takes 0.3 of
  // that of the 20 N s that slide, or all of 2 N s; no force over a gap, or where there will be one.
  const SurfaceContact rough = {ContactCondition::separate, 0.3};
  const double pressing      = time_step * 0.1 * 1e6 * 0.1 / 0.9;
  const auto fast = impulse_between(surface(-0.01, rough), spacing, time_step, {{20., -1.}});
  CHECK(fast[1] == Approx(pressing));
  CHECK(fast[0] == Approx(-0.3 * pressing));
  const auto slow = impulse_between(surface(-0.01, rough), spacing, time_step, {{2., -1.}});
  CHECK(slow[0] == Approx(-2.));
  CHECK(norm(impulse_between(surface(0.01, rough), spacing, time_step, {{2., -20.}})) == 0.);
  CHECK(norm(impulse_between(surface(-0.01, rough), spacing, time_step, {{2., 11.}})) == 0.);
}

TEST_CASE("Bodies that stick or slip do not part once they touch", "[boundary]")
{
  // Within dx/4 they keep the normal velocity of each other, those that stick all of it; what overlaps may part as fast
  // as that ends. Further away nothing holds them.
  const SurfaceContact slip = {ContactCondition::slip, 0.}, stick = {ContactCondition::stick, 0.};
  const auto slipping = impulse_between(surface(0.02, slip), spacing, time_step, {{2., 3.}});
  CHECK(norm(slipping - Vector<2>{{0., -3.}}) < 1e-14);
  const auto sticking = impulse_between(surface(0.02, stick), spacing, time_step, {{2., 3.}});
  CHECK(norm(sticking - Vector<2>{{-2., -3.}}) < 1e-14);
  const auto parting = impulse_between(surface(-0.01, stick), spacing, time_step, {{2., 12.}});
  CHECK(norm(parting - Vector<2>{{-2., -2.}}) < 1e-14);
  CHECK(norm(impulse_between(surface(0.03, stick), spacing, time_step, {{2., 3.}})) == 0.);
}

TEST_CASE("The softer of two bodies decides how hard they press", "[boundary]")
{
  // Two layers, one behind the other: half the modulus of equal ones, and that of the softer if the other is hard.
  CHECK(modulus_in_series(3., 3.) == Approx(1.5));
  CHECK(modulus_in_series(3., 3e9) == Approx(3.));
}
