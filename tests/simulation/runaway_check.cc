#include <magmpm/base/exceptions.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/simulation/runaway_check.h>

#include "catch.h"

#include <limits>

using namespace magmpm;

namespace
{
  /** A fluid of wave speed 2 m/s (K = 4, density 1) with three particles of this rank, at rest. */
  Body<2>
  quiet_body()
  {
    BodyParameters<2> parameters;
    parameters.name    = "drop";
    parameters.density = 1.;
    MaterialParameters material;
    material.law          = MechanicalLaw::viscoelastic_fluid;
    material.bulk_modulus = 4.;
    Body<2> body(parameters, material);
    body.particles.resize(3);
    for (int p = 0; p < 3; ++p)
      {
        body.particles.ids()[p] = 10 * parallel::rank(MPI_COMM_WORLD) + p;
        body.particles.component(ParticleProperty::deformation, 0)[p] = 1.;
        body.particles.component(ParticleProperty::position, 0)[p]    = 0.25;
        body.particles.component(ParticleProperty::position, 1)[p]    = 0.5;
      }
    return body;
  }

  /** What the check says with extremes of the bodies over all ranks; empty if it is content. */
  std::string
  message(const std::vector<Body<2>> &bodies)
  {
    std::vector<ParticleExtremes> extremes;
    for (const Body<2> &body : bodies)
      {
        ParticleExtremes e = {0., 0., 0., 1., 1.};
        for (std::size_t p = 0; p < body.particles.size(); ++p)
          {
            const double j     = body.particles.component(ParticleProperty::deformation, 0)[p];
            const double speed = norm(body.particles.vector(ParticleProperty::velocity, p));
            e.speed            = std::max(e.speed, std::isnan(speed) ? 1e300 : speed);
            e.max_volume_ratio = std::max(e.max_volume_ratio, j);
            e.max_inverse_volume_ratio = std::max(e.max_inverse_volume_ratio,
                                                  j > 0. ? 1. / j
                                                         : std::numeric_limits<double>::infinity());
          }
        const auto largest = [](double &value) { value = parallel::max(value, MPI_COMM_WORLD); };
        largest(e.speed);
        largest(e.max_volume_ratio);
        largest(e.max_inverse_volume_ratio);
        extremes.push_back(e);
      }
    Clock clock;
    clock.time      = 0.5;
    clock.step      = 7;
    clock.time_step = 0.125;
    try
      {
        check_for_runaways(bodies, extremes, RunawayLimits(), clock, "elastic", MPI_COMM_WORLD);
      }
    catch (const RunError &error)
      {
        return error.what();
      }
    return "";
  }

  /** The body with one number of one particle changed, on the last rank only. */
  Body<2>
  changed(const ParticleProperty quantity, const int particle, const double value)
  {
    Body<2> body = quiet_body();
    if (parallel::rank(MPI_COMM_WORLD) + 1 == parallel::n_ranks(MPI_COMM_WORLD))
      body.particles.component(quantity, 0)[particle] = value;
    return body;
  }

  std::string
  id_on_last_rank(const int particle)
  {
    return "particle " + std::to_string(10 * (parallel::n_ranks(MPI_COMM_WORLD) - 1) + particle) +
           " of body 'drop' ran away";
  }

  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace

TEST_CASE("particles within the limits are no runaways", "[simulation][mpi]")
{
  // J from 0.05 to 20 and up to 20 times the wave speed of 2 m/s are the documented defaults. At
  // the limits themselves, less rounding, nothing is said.
  CHECK(message({quiet_body()}) == "");
  CHECK(message({changed(ParticleProperty::deformation, 1, 0.0501)}) == "");
  CHECK(message({changed(ParticleProperty::deformation, 1, 19.99)}) == "");
  CHECK(message({changed(ParticleProperty::velocity, 1, 39.99)}) == "");
}

TEST_CASE("all ranks name the particle that ran away, when and how", "[simulation][mpi]")
{
  // One particle of the last rank is beyond one limit, and every rank throws the same message with
  // its id, the time at the end of the step, and the value with what is allowed.
  const std::string fast = message({changed(ParticleProperty::velocity, 2, -41.)});
  CHECK(
    contains(fast, id_on_last_rank(2) + " at t = 0.625 s (step 8, dt = 0.125 s, limit: elastic)"));
  CHECK(contains(fast, "J = 1 (allowed: 0.05 to 20), speed 41 m/s (allowed: up to 40 m/s)"));
  CHECK(contains(fast, "velocity (-41, 0) m/s, position (0.25, 0.5) m"));

  CHECK(contains(message({changed(ParticleProperty::deformation, 0, 0.049)}),
                 id_on_last_rank(0) + " at t = 0.625 s"));
  CHECK(contains(message({changed(ParticleProperty::deformation, 0, 20.5)}), "J = 20.5"));
  CHECK(contains(message({changed(ParticleProperty::deformation, 0, -1.)}), "J = -1"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(message({changed(ParticleProperty::velocity, 1, nan)}), id_on_last_rank(1)));
}

TEST_CASE("the particle furthest beyond a limit is named, of whatever body", "[simulation][mpi]")
{
  // Two particles are too fast and one is expanded 100 times, five times the limit, which is more
  // than the twice of the fast ones. The body is the second one; the first is quiet.
  Body<2> body = changed(ParticleProperty::deformation, 1, 100.);
  body.particles.component(ParticleProperty::velocity, 0)[0] = 60.;
  body.particles.component(ParticleProperty::velocity, 0)[2] = 80.;
  CHECK(contains(message({quiet_body(), body}), id_on_last_rank(1)));
}
