#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/motion/source_motion.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  template <int dim>
  SourceMotion<dim>
  motion_of(const std::string &position, const std::string &rotation = "")
  {
    SourceParameters<dim> parameters;
    parameters.name     = "ball";
    parameters.position = position;
    parameters.rotation = rotation;
    return SourceMotion<dim>(parameters);
  }
} // namespace

TEST_CASE("the velocity of a source is the derivative of its position", "[motion]")
{
  // Analytic derivatives of a line, a sine of 50 Hz and a root, which is not defined before t = 0.
  // The stated error of the difference is (1e-6 w)^2/6 = 1.6e-8 of the amplitude's w, and 1e-10.
  const double w             = 2. * constants::pi * 50.;
  const SourceMotion<2> sine = motion_of<2>("0.2 - 0.1*t; 0.01*sin(2*pi*50*t)");
  for (const double t : {0., 1e-7, 0.0123, 1.})
    {
      const Vector<2> velocity = sine.motion(t).velocity;
      CHECK(velocity[0] == Approx(-0.1).epsilon(2e-9));
      CHECK(velocity[1] == Approx(0.01 * w * std::cos(w * t)).margin(0.01 * w * 2e-7));
    }
  const SourceMotion<2> root = motion_of<2>("sqrt(t); 0");
  CHECK(root.motion(0.25).velocity[0] == Approx(1.).epsilon(1e-8));
  CHECK(std::isfinite(root.motion(0.).velocity[0]));
  CHECK(norm(motion_of<2>("tan(0.5)*1e5; sqrt(2)").motion(1.).velocity) == 0.);
}

TEST_CASE("the spin of a source is the derivative of its rotation", "[motion]")
{
  // A rotation vector of constant direction turns at its derivative; turning and precessing ones are
  // told by dR/dt = omega x R, here by a difference of the rotation over 2e-4 s.
  CHECK(motion_of<2>("0; 0", "3*t").motion(0.7).angular_velocity[0] == Approx(3.).epsilon(1e-9));
  CHECK(motion_of<3>("0; 0; 0", "0; 2*t^2; 0").motion(0.5).angular_velocity[1] ==
        Approx(2.).epsilon(1e-9));
  const SourceMotion<3> precession = motion_of<3>("0; 0; 0", "cos(2*t); sin(2*t); t");
  const double t = 0.3, h = 1e-4;
  const Matrix<3> rate =
    (1. / (2. * h)) * (precession.pose(t + h).rotation + (-1.) * precession.pose(t - h).rotation);
  const Vector<3> omega = precession.motion(t).angular_velocity;
  const Vector<3> arm   = precession.pose(t).rotation * Vector<3>{{0.3, -0.5, 0.7}};
  CHECK(norm(cross(omega, arm) - rate * Vector<3>{{0.3, -0.5, 0.7}}) < 1e-6);
  CHECK(norm(omega) > 1.);
}

TEST_CASE("key frames and expressions of a motion exclude each other", "[motion]")
{
  SourceParameters<2> both;
  both.name       = "ball";
  both.key_frames = "0, 0, 0; 1, 2, 4";
  CHECK(SourceMotion<2>(both).motion(0.5).velocity[1] == Approx(4.).epsilon(1e-9));
  CHECK(norm(SourceMotion<2>(both).motion(1.5).velocity) == 0.);
  both.rotation = "t";
  CHECK_THROWS_WITH(
    SourceMotion<2>(both),
    "Source 'ball' has key frames and expressions of its motion. Give either the key "
    "frames, or position, rotation and strength.");
}
