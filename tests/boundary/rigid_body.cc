#include <magmpm/base/constants.h>
#include <magmpm/boundary/rigid_body.h>

#include "catch.h"

using namespace magmpm;

namespace
{
  /** A body of density 2000 kg/m^3 in the shape of a box. */
  template <int dim>
  RigidBody<dim>
  free_box(const Vector<dim> &lower, const Vector<dim> &upper)
  {
    ShapeParameters<dim> parameters;
    parameters.lower_corner                       = lower;
    parameters.upper_corner                       = upper;
    const std::shared_ptr<const Shape<dim>> shape = make_shape(parameters);
    RigidBody<dim> body("box", shape, {ContactCondition::stick, 0.});
    body.set_free(2000. * shape->volume_moments().volume);
    return body;
  }

  double
  orthogonality_error(const Matrix<3> &rotation)
  {
    return frobenius_norm(transpose(rotation) * rotation + (-1.) * identity<3>());
  }
} // namespace

TEST_CASE("mass and inertia of a box", "[boundary]")
{
  // Edges a, b, c: the moments are m (b^2 + c^2)/12 and so on; in 2D m (a^2 + b^2)/12.
  const RigidBody<3> body = free_box<3>({{1., 2., 3.}}, {{1.1, 2.2, 3.4}});
  const double mass       = 2000. * 0.1 * 0.2 * 0.4;
  CHECK(body.mass() == Approx(mass));
  const Matrix<3> inertia = body.inertia();
  CHECK(inertia(0, 0) == Approx(mass * (0.04 + 0.16) / 12.));
  CHECK(inertia(1, 1) == Approx(mass * (0.01 + 0.16) / 12.));
  CHECK(inertia(2, 2) == Approx(mass * (0.01 + 0.04) / 12.));
  CHECK(std::abs(inertia(0, 1)) < 1e-12);
  CHECK(norm(body.pose().position - Vector<3>{{1.05, 2.1, 3.2}}) < 1e-12);

  const RigidBody<2> flat = free_box<2>({{0., 0.}}, {{0.1, 0.3}});
  CHECK(flat.mass() == Approx(60.));
  CHECK(flat.inertia()(0, 0) == Approx(60. * 0.1 / 12.));
}

TEST_CASE("a body that tumbles freely keeps energy and angular momentum", "[boundary]")
{
  // Three different moments, spun about an axis near the middle one, where the motion is unstable and
  // turns over again and again. The angular momentum in the world is kept to rounding, the rotation
  // stays one, and the energy swings by O(dt^2) without drift: a quarter with half the step.
  const auto swing = [](const double time_step) {
    RigidBody<3> body = free_box<3>({{0., 0., 0.}}, {{0.1, 0.2, 0.4}});
    body.set_motion({{{0.1, 0.2, 0.3}}, {{0.05, 10., 0.02}}});
    const Vector<3> momentum = body.angular_momentum();
    const double energy      = body.kinetic_energy();
    double largest = 0., late = 0., least_alignment = 1.;
    const int n_steps = static_cast<int>(20. / time_step + 0.5);
    for (int step = 0; step < n_steps; ++step)
      {
        body.advance(time_step);
        const double change = std::abs(body.kinetic_energy() / energy - 1.);
        largest             = std::max(largest, change);
        if (step > n_steps / 2)
          late = std::max(late, change);
        const Vector<3> axis = body.pose().rotation * Vector<3>{{0., 1., 0.}};
        least_alignment      = std::min(least_alignment, dot(axis, momentum) / norm(momentum));
      }
    CHECK(norm(body.angular_momentum() - momentum) == 0.);
    CHECK(norm(body.inertia() * body.motion().angular_velocity - momentum) <
          1e-12 * norm(momentum));
    CHECK(orthogonality_error(body.pose().rotation) < 1e-13);
    CHECK(norm(body.pose().position - Vector<3>{{2.05, 4.1, 6.2}}) < 1e-9);
    CHECK(least_alignment < -0.9); // it did turn over
    CHECK(late < 1.1 * largest);
    return largest;
  };
  const double coarse = swing(2e-3), fine = swing(1e-3);
  INFO("energy swings by " << coarse << " and " << fine << " of itself");
  CHECK(coarse < 1e-3);
  CHECK(coarse / fine == Approx(4.).epsilon(0.1));
}

TEST_CASE("a symmetric body precesses as Euler's equations say", "[boundary]")
{
  // Moments I, I, J: the axis goes around the angular momentum at L/I. After one period, with a step
  // of a thousandth of it, it is back where it began; the error is of second order in the step.
  const auto miss = [](const int n_steps) {
    RigidBody<3> body = free_box<3>({{0., 0., 0.}}, {{0.1, 0.1, 0.3}});
    body.set_motion({{}, {{3., 0., 5.}}});
    const double period = 2. * constants::pi /
                          (norm(body.angular_momentum()) / body.inertia()(0, 0));
    for (int step = 0; step < n_steps; ++step)
      body.advance(period / n_steps);
    return norm(body.pose().rotation * Vector<3>{{0., 0., 1.}} - Vector<3>{{0., 0., 1.}});
  };
  const double coarse = miss(500), fine = miss(1000);
  INFO("misses by " << coarse << " and " << fine);
  CHECK(fine < 1e-4);
  CHECK(coarse / fine == Approx(4.).epsilon(0.1));
}

TEST_CASE("a record holds all that changes of a rigid body", "[boundary]")
{
  // A body that tumbled is written and read into one at rest: the two are equal, and stay so.
  RigidBody<3> one = free_box<3>({{0., 0., 0.}}, {{0.1, 0.2, 0.4}}), other = one;
  one.set_motion({{{0.1, 0.2, 0.3}}, {{1., 2., 3.}}});
  one.advance(0.1);
  std::vector<double> record;
  one.append_record(record);
  std::size_t place = 0;
  other.read_record(record, place);
  CHECK(place == record.size());
  one.advance(0.1);
  other.advance(0.1);
  CHECK(norm(one.pose().position - other.pose().position) == 0.);
  CHECK(frobenius_norm(one.pose().rotation + (-1.) * other.pose().rotation) == 0.);
  CHECK(norm(one.motion().angular_velocity - other.motion().angular_velocity) == 0.);
}

TEST_CASE("surfaces of a moved body are found in the world", "[boundary]")
{
  // A box of half edges 0.1 and 0.2 around (1, 1), moved to (3, 3) and turned by a quarter: a point
  // 0.3 beside it along x is 0.1 from what was its upper end, and moves with it.
  RigidBody<2> body = free_box<2>({{0.9, 0.8}}, {{1.1, 1.2}});
  body.set_pose({{{3., 3.}}, rotation_by<2>({{-0.5 * constants::pi}})});
  body.set_motion({{{1., 2.}}, {{10.}}});
  const Vector<2> point            = {{3.3, 3.02}};
  const SurfaceDistance<2> nearest = body.surface_distance(point);
  CHECK(nearest.distance == Approx(0.1));
  CHECK(norm(nearest.normal - Vector<2>{{1., 0.}}) < 1e-12);
  CHECK(norm(body.velocity_at(point) - Vector<2>{{1. - 0.2, 2. + 3.}}) < 1e-12);
  CHECK(body.is_near(point, 0.1));
  CHECK(!body.is_near(point, 0.07));
  CHECK(norm(body.pose_of_shape().to_world({{1., 1.2}}) - Vector<2>{{3.2, 3.}}) < 1e-12);
}
