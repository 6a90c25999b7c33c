#include <magmpm/base/constants.h>
#include <magmpm/motion/expression.h>
#include <magmpm/motion/key_frames.h>
#include <magmpm/motion/pose_function.h>

#include "catch.h"

#include <cmath>

using namespace magmpm;

namespace
{
  template <int dim>
  TimeFunction<Pose<dim>>
  pose_of(const std::string &position, const std::string &rotation = dim == 3 ? "0; 0; 0" : "0")
  {
    return pose_function<dim>(read_expression<dim>(position, "Position of source 'ball'"),
                              read_expression<n_axial_components<dim>>(rotation, "Rotation"));
  }
} // namespace

TEST_CASE("the velocity of a source is the derivative of its position", "[motion]")
{
  // Analytic derivatives of a line, a sine of 50 Hz and a root, which is not defined before t = 0.
  // The stated error of the difference is (1e-6 w)^2/6 = 1.6e-8 of the amplitude's w, and 1e-10.
  const double w                   = 2. * constants::pi * 50.;
  const TimeFunction<Pose<2>> sine = pose_of<2>("0.2 - 0.1*t; 0.01*sin(2*pi*50*t)");
  for (const double t : {0., 1e-7, 0.0123, 1.})
    {
      const Vector<2> velocity = motion_at(sine, t).velocity;
      CHECK(velocity[0] == Approx(-0.1).epsilon(2e-9));
      CHECK(velocity[1] == Approx(0.01 * w * std::cos(w * t)).margin(0.01 * w * 2e-7));
    }
  const TimeFunction<Pose<2>> root = pose_of<2>("sqrt(t); 0");
  CHECK(motion_at(root, 0.25).velocity[0] == Approx(1.).epsilon(1e-8));
  CHECK(std::isfinite(motion_at(root, 0.).velocity[0]));
  CHECK(norm(motion_at(pose_of<2>("tan(0.5)*1e5; sqrt(2)"), 1.).velocity) == 0.);
}

TEST_CASE("the spin of a source is the derivative of its rotation", "[motion]")
{
  // A rotation vector of constant direction turns at its derivative; turning and precessing ones are
  // told by dR/dt = omega x R, here by a difference of the rotation over 2e-4 s.
  CHECK(motion_at(pose_of<2>("0; 0", "3*t"), 0.7).angular_velocity[0] == Approx(3.).epsilon(1e-9));
  CHECK(motion_at(pose_of<3>("0; 0; 0", "0; 2*t^2; 0"), 0.5).angular_velocity[1] ==
        Approx(2.).epsilon(1e-9));
  const TimeFunction<Pose<3>> precession = pose_of<3>("0; 0; 0", "cos(2*t); sin(2*t); t");
  const double t = 0.3, h = 1e-4;
  const Matrix<3> rate = (1. / (2. * h)) *
                         (precession(t + h).rotation + (-1.) * precession(t - h).rotation);
  const Vector<3> omega = motion_at(precession, t).angular_velocity;
  const Vector<3> arm   = precession(t).rotation * Vector<3>{{0.3, -0.5, 0.7}};
  CHECK(norm(cross(omega, arm) - rate * Vector<3>{{0.3, -0.5, 0.7}}) < 1e-6);
  CHECK(norm(omega) > 1.);
}

// From (0, 0) to (2, 4) in one second, linearly: 4 m/s along y; after the last frame it rests.
TEST_CASE("the velocity between key frames is that of their way", "[motion]")
{
  const TimeFunction<Pose<2>> pose =
    read_key_frames<2>("0, 0, 0; 1, 2, 4", KeyFrameInterpolation::linear, "Key frames").pose;
  CHECK(motion_at(pose, 0.5).velocity[1] == Approx(4.).epsilon(1e-9));
  CHECK(norm(motion_at(pose, 1.5).velocity) == 0.);
}

TEST_CASE("a function of time that was made of constants is constant", "[motion]")
{
  // So nothing that never moves is evaluated in each step, and a field of it counts as constant.
  CHECK(pose_of<3>("0; 1; 2", "0; 0; pi/2").is_constant());
  CHECK(!pose_of<3>("0; 1; 2", "0; 0; t").is_constant());
  CHECK(!pose_of<3>("0; t; 2").is_constant());
  const auto twice = [](const double x) { return 2. * x; };
  CHECK(TimeFunction<double>(3.).transformed(twice)(1.) == 6.);
  CHECK(TimeFunction<double>(3.).transformed(twice).is_constant());
  const TimeFunction<double> square([](const double t) { return t * t; });
  CHECK(square.transformed(twice)(3.) == 18.);
  CHECK(!square.transformed(twice).is_constant());
}
