#include <magmpm/base/constants.h>
#include <magmpm/base/exceptions.h>
#include <magmpm/motion/key_frames.h>

#include "../catch.h"

#include <cmath>
#include <cstdio>
#include <fstream>

using namespace magmpm;

namespace
{
  const std::string quarter = std::to_string(constants::pi / 2.);
  const std::string table   = "0, 0, 0, 0,  0, 0, 0,  1; 2, 1, 2, 4,  0, 0, " + quarter +
                            ",  3; 3, 1, 2, 4,  0, 0, " + quarter + ",  0";

  template <int dim>
  KeyFrames<dim>
  frames(const std::string &table,
         const KeyFrameInterpolation interpolation = KeyFrameInterpolation::linear)
  {
    return read_key_frames<dim>(table, interpolation, "Key frames of source 'ball'");
  }
} // namespace

TEST_CASE("between key frames the way is straight and the rotation about one axis", "[motion]")
{
  // Half of a quarter turn about z, half of the way and of the change of strength in the middle; the
  // first and last poses before and after.
  const KeyFrames<3> motion = frames<3>(table);
  CHECK(norm(motion.pose(-1.).position) == 0.);
  CHECK(motion.pose(1.).position[2] == 2.);
  CHECK(motion.strength(1.) == 2.);
  const Vector<3> turned = motion.pose(1.).rotation * Vector<3>{{1., 0., 0.}};
  CHECK(turned[0] == Approx(std::sqrt(0.5)).epsilon(1e-6));
  CHECK(turned[1] == Approx(std::sqrt(0.5)).epsilon(1e-6));
  CHECK(motion.strength(2.5) == 1.5);
  CHECK(motion.pose(9.).position[1] == 2.);
  CHECK(motion.strength(9.) == 0.);
  CHECK(!motion.pose.is_constant());
  CHECK(!motion.strength.is_constant());
}

TEST_CASE("slerp takes the shorter way about the axis of the relative rotation", "[motion]")
{
  // From a turn by 1 about x to one by 2.5 about y: every pose on the way is the start turned about one
  // axis, by parts of one angle, which the trace of the relative rotation tells: 1 + 2 cos(angle).
  const KeyFrames<3> motion = frames<3>("0, 0, 0, 0, 1, 0, 0; 1, 0, 0, 0, 0, 2.5, 0");
  const Matrix<3> start = motion.pose(0.).rotation, end = motion.pose(1.).rotation;
  const auto angle = [](const Matrix<3> &from, const Matrix<3> &to) {
    return std::acos(0.5 * (trace(to * transpose(from)) - 1.));
  };
  const double whole = angle(start, end);
  for (const double t : {0.25, 0.5, 0.9})
    {
      CHECK(angle(start, motion.pose(t).rotation) == Approx(t * whole).epsilon(1e-9));
      CHECK(angle(motion.pose(t).rotation, end) == Approx((1. - t) * whole).epsilon(1e-9));
      CHECK(determinant(motion.pose(t).rotation) == Approx(1.));
    }
  // Nearly half a turn against the axis.
  const KeyFrames<3> against = frames<3>("0, 0, 0, 0, 0, 0, 0; 1, 0, 0, 0, -3, 0, 0");
  CHECK(against.pose(0.5).rotation(2, 1) == Approx(-std::sin(1.5)));
  // By 350 degrees forward is by 10 backward; half a turn is found too.
  const KeyFrames<2> back =
    frames<2>("0, 0, 0, 0; 1, 0, 0, " + std::to_string(35. / 18. * constants::pi));
  CHECK(back.pose(0.5).rotation(1, 0) == Approx(-std::sin(constants::pi / 36.)).epsilon(1e-5));
  const KeyFrames<3> half = frames<3>("0, 0, 0, 0, 0, 0, 0; 1, 0, 0, 0, 3.14159265358979, 0, 0");
  CHECK(half.pose(0.5).rotation(1, 2) * half.pose(0.5).rotation(2, 1) == Approx(-1.));
}

TEST_CASE("smooth key frames are reached at rest", "[motion]")
{
  // 3 s^2 - 2 s^3: a half in the middle, 5/32 after a quarter; no velocity at the ends.
  const KeyFrames<3> motion = frames<3>(table, KeyFrameInterpolation::smooth);
  CHECK(motion.pose(1.).position[0] == 0.5);
  CHECK(motion.pose(0.5).position[0] == Approx(5. / 32.));
  CHECK(motion.pose(1e-4).position[0] < 1e-8);
  CHECK(motion.strength(0.5) == Approx(1. + 2. * 5. / 32.));
}

TEST_CASE("key frames that do not move are constant", "[motion]")
{
  // Rotation and strength may be left out; poses are compared, not the number of rows.
  const KeyFrames<2> still = frames<2>("0, 0.5, 0.5; 1, 0.5, 0.5");
  CHECK(still.pose.is_constant());
  CHECK(still.strength.is_constant());
  const KeyFrames<2> faded = frames<2>("0, 0.5, 0.5, 0, 1; 1, 0.5, 0.5, 0, 0");
  CHECK(faded.pose.is_constant());
  CHECK(!faded.strength.is_constant());
  CHECK(!frames<2>("0, 0, 0, 0; 1, 0, 0, 0.1").pose.is_constant());
}

// Half way between (0, 0) and (1, 3) y is 1.5; all that may stand in such a file beside numbers
// does.
TEST_CASE("key frames come from a file, with headings and comments", "[motion]")
{
  const std::string name = "key_frames_test.csv";
  std::ofstream(name) << "t, x, y, angle\n# a comment\n\n0, 0, 0, 0\r\n2, 1, 3, 0\n";
  CHECK(frames<2>(name).pose(1.).position[1] == 1.5);
  std::remove(name.c_str());
}

TEST_CASE("wrong key frames are refused with their row", "[motion]")
{
  // The wording, which users meet.
  CHECK_THROWS_WITH(
    frames<3>("nowhere.csv"),
    "Key frames of source 'ball': there is no file 'nowhere.csv' that can be read. "
    "Give the name of a CSV file, or the rows themselves, separated by semicolons.");
  CHECK_THROWS_WITH(
    frames<3>("0, 1, 2; 1, 2, 3"),
    "Key frames of source 'ball': the row '0, 1, 2' has 3 numbers. Give in each row: "
    "time, x, y, z, then either nothing more, or the rotation (three numbers), or the "
    "rotation and the strength.");
  CHECK_THROWS_WITH(frames<2>("0, 1, 2; 0, 2, 3"),
                    "Key frames of source 'ball': the time of the row '0, 2, 3' is not later than "
                    "that of the row before it. Times must increase.");
  CHECK_THROWS_WITH(frames<2>("0, 1, two"),
                    "Key frames of source 'ball': ' two' in the row '0, 1, two' is not a number.");
  CHECK_THROWS_WITH(
    frames<2>("0, 1, 2; 1, 2, 3, 4"),
    "Key frames of source 'ball': the row '1, 2, 3, 4' has 4 numbers, the one before "
    "it 3. All rows must have equally many.");
  CHECK_THROWS_AS(frames<2>("0, 1, 2; 1, 2, 3, 4"), InputError);
}
