#include "catch.h"

#include <magmpm/coupling/carried_force.h>
#include <magmpm/coupling/carried_reaction.h>
#include <magmpm/coupling/extrapolation.h>
#include <magmpm/coupling/force_moments.h>

using namespace magmpm;

namespace
{
  template <int dim>
  Body<dim>
  body_of_two_particles(const bool is_magnetic)
  {
    BodyParameters<dim> parameters;
    parameters.density = 1000.;
    MaterialParameters material;
    material.shear_modulus = 1e5;
    if (is_magnetic)
      {
        material.magnetic.saturation_magnetization = 8e4;
        material.magnetic.initial_susceptibility   = 0.9;
      }
    Body<dim> body(parameters, material);
    body.particles.resize(2);
    return body;
  }

  template <int dim>
  void
  set_acceleration(const double value, Body<dim> &body)
  {
    for (const ParticleProperty quantity : {ParticleProperty::magnetic_acceleration,
                                            ParticleProperty::magnetic_acceleration_gradient})
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        for (int c = 0; c < body.particles.n_components(quantity); ++c)
          body.particles.component(quantity, c)[p] = value * (1. + c + 10. * p);
  }

  /** A solve @p way after the last one, at which the acceleration is @p value. */
  template <int dim>
  void
  solve(const double way, const double value, Body<dim> &body)
  {
    recall_carried_force(way, body);
    set_acceleration(value, body);
    set_rate_of_carried_force(way, body);
  }

  template <int dim>
  double
  acceleration(const Body<dim> &body, const std::size_t p, const int d)
  {
    return body.particles.component(ParticleProperty::magnetic_acceleration, d)[p];
  }

  /** Of the gradient, number @p c by rows. */
  template <int dim>
  double
  slope(const Body<dim> &body, const std::size_t p, const int c)
  {
    return body.particles.component(ParticleProperty::magnetic_acceleration_gradient, c)[p];
  }
} // namespace

// A force that changes evenly along the way is carried exactly after two solves, in steps of any length
// and between solves at any distance: extrapolation is exact for linear functions.
TEMPLATE_TEST_CASE_SIG("A force that changes evenly is carried exactly",
                       "[coupling]",
                       ((int dim), dim),
                       2,
                       3)
{
  const auto exact = [](const double way) { return 100. + 30. * way; };
  Body<dim> body   = body_of_two_particles<dim>(true);
  solve(0., exact(0.), body);
  advance_carried_force(0.4, body);
  CHECK(acceleration(body, 0, 0) == exact(0.)); // no rate yet
  double time = 0.4, last = 0.;
  for (const double next : {0.4, 1.1, 1.3})
    {
      for (; time < next - 1e-12; time += 0.1)
        advance_carried_force(0.1, body);
      solve(next - last, exact(next), body);
      last = time = next;
      advance_carried_force(0.25, body);
      for (std::size_t p = 0; p < 2; ++p)
        for (int d = 0; d < dim; ++d)
          CHECK(acceleration(body, p, d) ==
                Approx(exact(next + 0.25) * (1. + d + 10. * p)).epsilon(1e-12));
      for (std::size_t p = 0; p < 2; ++p)
        for (int c = 0; c < dim * dim; ++c)
          CHECK(slope(body, p, c) ==
                Approx(exact(next + 0.25) * (1. + c + 10. * p)).epsilon(1e-12));
      advance_carried_force(-0.25, body);
    }
}

// A sudden force, such as of a magnet switched on, is not carried on: over a way as long as the last one
// it may change by half of itself, no more. A body that is not magnetic has no force to carry.
TEMPLATE_TEST_CASE_SIG("A sudden force is not carried on", "[coupling]", ((int dim), dim), 2, 3)
{
  Body<dim> body = body_of_two_particles<dim>(true);
  solve(0., 0., body);
  solve(0.2, 100., body);
  advance_carried_force(0.2, body);
  CHECK(acceleration(body, 0, 0) == Approx(150.).epsilon(1e-12));

  // Held, it is that of the last solve again, and stays so.
  freeze_carried_force(0.2, body);
  advance_carried_force(0.7, body);
  CHECK(acceleration(body, 0, 0) == Approx(100.).epsilon(1e-12));

  Body<dim> other = body_of_two_particles<dim>(false);
  recall_carried_force(0.1, other);
  set_rate_of_carried_force(0.1, other);
  CHECK(other.particles.n_components(ParticleProperty::magnetic_acceleration_rate) == 0);
}

// An error that grows with the square of the way meets the tolerance after a few intervals, from wherever they
// start: in steps by a factor of 0.4 to 2. Without an error they grow to all that is tolerated, and no error
// makes them shorter than a fifth.
TEST_CASE("Intervals between solves find the way that the tolerance allows", "[coupling]")
{
  const double tolerance = 0.003, exact = 0.6;
  const auto error = [&](const double taken) { return tolerance * std::pow(taken / exact, 2); };
  for (const double start : {0.2, 1.})
    {
      double share = start;
      for (int solve = 0; solve < 4; ++solve)
        {
          const double next = next_share(share, share, error(share), tolerance);
          CHECK(next <= 2. * share);
          CHECK(next >= 0.4 * share);
          share = next;
        }
      CHECK(share == Approx(exact));
    }
  CHECK(next_share(0.3, 0.3, 0., tolerance) == Approx(0.6));
  CHECK(next_share(0.8, 0.8, 0., tolerance) == 1.);
  CHECK(next_share(0.3, 0.3, 1., tolerance) == 0.2);
}

// Two particles of 1 and 2 kg with accelerations along x and y and gradients: sums by hand. Twice the force is off by
// one half of itself, in everything.
TEST_CASE("Force and virial of what particles carry are sums over them", "[coupling]")
{
  const double spacing = 0.2;
  Lattice<2> lattice;
  lattice.spacing = spacing;
  std::vector<Body<2>> bodies(1, body_of_two_particles<2>(true));
  bodies.push_back(body_of_two_particles<2>(false));
  set_acceleration(1., bodies[0]); // a = (1, 2) and (11, 12), A = (1, 2; 3, 4) and ten more
  for (std::size_t p = 0; p < 2; ++p)
    {
      bodies[0].particles.component(ParticleProperty::mass, 0)[p]     = 1. + p;
      bodies[0].particles.component(ParticleProperty::position, 0)[p] = 3. * p;
      bodies[0].particles.component(ParticleProperty::position, 1)[p] = 6.;
    }
  const ForceMoments<2> moments = force_moments(bodies, lattice, MPI_COMM_SELF);
  CHECK(moments.mass == Approx(3.));
  CHECK(moments.force[0] == Approx(23.));
  CHECK(moments.force[1] == Approx(26.));
  CHECK(moments.size == Approx(std::sqrt(5.) + 2. * std::sqrt(265.)));
  // The centre of mass is (2, 6): only x counts in f x^T, by -2 and +1; dx^2/4 = 0.01.
  const Matrix<2> virial = moments.virial();
  CHECK(virial(0, 0) == Approx(-2. * 1. + 22. + 0.01 * (1. + 2. * 11.)));
  CHECK(virial(0, 1) == Approx(0.01 * (2. + 2. * 12.)));
  CHECK(virial(1, 0) == Approx(-2. * 2. + 24. + 0.01 * (3. + 2. * 13.)));
  CHECK(virial(1, 1) == Approx(0.01 * (4. + 2. * 14.)));

  std::vector<Body<2>> twice = bodies;
  set_acceleration(2., twice[0]);
  CHECK(relative_difference(moments, force_moments(twice, lattice, MPI_COMM_SELF)) == Approx(0.5));
}

// m (a_then + a_now)/2 . (x - x_then), a growing evenly from 3 to 3.5 times (1, 2(, 3)) on the way; the second
// particle has ten times (1, 1(, 1)) more, and twice the mass. Without material there is no work.
TEMPLATE_TEST_CASE_SIG("The carried force does its work since the solve",
                       "[coupling]",
                       ((int dim), dim),
                       2,
                       3)
{
  Body<dim> body              = body_of_two_particles<dim>(true);
  ParticleSet<dim> &particles = body.particles;
  solve<dim>(0., 2.5, body);
  solve<dim>(1., 3., body);
  advance_carried_force<dim>(1., body);
  double expected = 0.;
  for (std::size_t p = 0; p < 2; ++p)
    {
      particles.component(ParticleProperty::mass, 0)[p] = 1. + p;
      for (int d = 0; d < dim; ++d)
        {
          particles.component(ParticleProperty::position_at_solve, d)[p] = 0.3;
          particles.component(ParticleProperty::position, d)[p]          = 0.4 + 0.1 * d;
          expected += (1. + p) * 3.25 * (1. + d + 10. * p) * (0.1 + 0.1 * d);
        }
    }
  CHECK(work_since_solve(1., body) == Approx(expected));
  CHECK(work_since_solve(1., body_of_two_particles<dim>(false)) == 0.);
}

// What the material does to a source is found at some of the solves, and goes on at the rate between these: from 100
// to 150 over two solves 0.2 and 0.3 apart it is 160 another 0.1 later. Without a rate, or held, it stays.
TEST_CASE("The force on a magnet is carried from one solve that finds it to the next", "[coupling]")
{
  std::vector<ForceAndTorque<2>> found(1);
  const auto force = [](const CarriedReactions<2> &reactions) { return reactions.on(0).force[0]; };
  CarriedReactions<2> reactions;
  CHECK(reactions.are_of_last_solve());
  reactions.note_solve(0.);
  CHECK_FALSE(reactions.are_of_last_solve());
  found[0].force[0] = 100.;
  reactions.set(found, true);
  CHECK(reactions.are_of_last_solve());
  reactions.advance(0.2);
  CHECK(force(reactions) == 100.);
  reactions.note_solve(0.2);
  reactions.note_solve(0.3);
  found[0].force[0] = 150.;
  reactions.set(found, true);
  reactions.advance(0.1);
  CHECK(force(reactions) == Approx(160.));
  reactions.freeze();
  CHECK(force(reactions) == Approx(150.));
  reactions.note_solve(0.1);
  found[0].force[0] = 170.;
  reactions.set(found, false);
  reactions.advance(0.1);
  CHECK(force(reactions) == 170.);
}
