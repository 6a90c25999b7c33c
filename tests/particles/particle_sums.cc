#include <magmpm/base/constants.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/particles/particle_sums.h>
#include <magmpm/particles/seeding.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** Writes numbers down in the order in which they come. */
  struct Recorder
  {
    std::vector<double> numbers;

    template <typename T>
    void
    sum(T &member)
    {
      parallel::for_each_number(member, [&](const double number) { numbers.push_back(number); });
    }

    void
    max(const double number)
    {
      numbers.push_back(number);
    }

    void
    min(const double number)
    {
      numbers.push_back(number);
    }
  };

  /** All numbers of the sums. */
  template <int dim>
  std::vector<double>
  numbers(ParticleSums<dim> sums)
  {
    Recorder recorder;
    sums.for_each_member(recorder);
    return recorder.numbers;
  }

  /** To rounding, relative to the larger one of each pair. */
  template <int dim>
  void
  check_equal(const ParticleSums<dim> &one, const ParticleSums<dim> &other)
  {
    const std::vector<double> a = numbers(one), b = numbers(other);
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        CAPTURE(i);
        CHECK(a[i] == Approx(b[i]).epsilon(1e-11).margin(1e-11));
      }
  }

  /** A body with a single particle. */
  Body<3>
  one_particle()
  {
    Body<3> body              = empty_body<3>(MechanicalLaw::viscoelastic_fluid, true);
    ParticleSet<3> &particles = body.particles;
    particles.resize(1);
    const auto set = [&](const ParticleProperty quantity, const std::vector<double> &values) {
      for (std::size_t c = 0; c < values.size(); ++c)
        particles.component(quantity, static_cast<int>(c))[0] = values[c];
    };
    set(ParticleProperty::position, {1., 2., 3.});
    set(ParticleProperty::velocity, {2., -1., 2.});
    set(ParticleProperty::affine_velocity, {0., -7., 5., 7., 0., -3., -5., 3., 0.});
    set(ParticleProperty::deformation, {0.8});
    set(ParticleProperty::mass, {2.});
    set(ParticleProperty::volume, {0.5});
    set(ParticleProperty::magnetic_acceleration, {0., 3., 4.});
    set(ParticleProperty::magnetic_field, {0., 6., 8.});
    return body;
  }
} // namespace

TEST_CASE("the sums of one particle are those of the formulas", "[particles]")
{
  // Mass 2, speed 3, J = 0.8, V_0 = 0.5, K = 1.3, chi_0 = 0.9 (linear law) and dx = 0.1: numbers
  // worked out by hand. C is the rotation (3, 5, 7), whose curl is twice that; compressed to 0.8 the
  // susceptibility is 0.9/0.8, but the moment J V_0 M stays that of the undeformed volume.
  const ParticleSums<3> sums =
    particle_sums(one_particle(), test_lattice<3>(), {{0., 0., -10.}}, MagnetizationLaw::linear);
  CHECK(sums.n_particles == 1.);
  CHECK(sums.mass == 2.);
  CHECK(sums.kinetic_energy == Approx(9.));
  CHECK(sums.elastic_energy == Approx(0.5 * 0.5 * 1.3 * 0.04));
  CHECK(sums.gravitational_energy == Approx(60.));
  CHECK(norm(sums.momentum - Vector<3>{{4., -2., 4.}}) < 1e-14);
  CHECK(norm(sums.mass_times_position - Vector<3>{{2., 4., 6.}}) < 1e-14);
  // 2 x cross v = 2 (7, 4, -5), and 2 dx^2/4 (6, 10, 14) = 0.005 (6, 10, 14).
  CHECK(norm(sums.angular_momentum - Vector<3>{{14.03, 8.05, -9.93}}) < 1e-13);
  CHECK(norm(sums.magnetic_force - Vector<3>{{0., 6., 8.}}) < 1e-14);
  CHECK(norm(sums.magnetic_moment - Vector<3>{{0., 0.45 * 6., 0.45 * 8.}}) < 1e-14);
  CHECK(sums.max_speed == Approx(3.));
  CHECK(sums.min_volume_ratio == 0.8);
  CHECK(sums.max_volume_ratio == 0.8);
  CHECK(sums.max_field == Approx(10.));
  CHECK(sums.max_magnetization == Approx(9. / 0.8));
  CHECK(sums.max_magnetic_acceleration == Approx(5.));
  // rho = 2/(0.8 0.5) = 5.
  CHECK(sums.max_magnetic_wave_speed ==
        Approx(9. / 0.8 * std::sqrt(constants::vacuum_permeability / 5.)));
}

TEMPLATE_TEST_CASE_SIG("sums of parts combine to those of the whole",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // 300 random particles of a magnetic solid in one body, and in three bodies of 100. Sums add up
  // and extremes are the extremes of extremes, to rounding; nothing at all changes nothing.
  const Lattice<dim> lattice = test_lattice<dim>();
  const auto sums_of         = [&](const Body<dim> &body) {
    Vector<dim> gravity;
    gravity[1] = -9.81;
    return particle_sums(body, lattice, gravity, MagnetizationLaw::langevin);
  };
  Body<dim> whole = empty_body<dim>(MechanicalLaw::neo_hookean, true);
  Random random(11);
  add_random_particles(lattice, 0., 16., 300, random, whole);

  ParticleSums<dim> combined;
  for (int part = 0; part < 3; ++part)
    {
      Body<dim> body = empty_body<dim>(MechanicalLaw::neo_hookean, true);
      std::vector<double> records;
      for (int p = 100 * part; p < 100 * (part + 1); ++p)
        whole.particles.append_record(p, records);
      body.particles.append_from_records(records.data(), 100);
      combined += sums_of(body);
    }
  combined += ParticleSums<dim>();
  check_equal(combined, sums_of(whole));
}

TEST_CASE("the sums of all ranks are those of one", "[particles][mpi]")
{
  // A spinning, jittered box seeded by all ranks, its sums combined by MPI, against the sums of the
  // same box seeded by one rank. The particles are the same, so only the order of the sums differs.
  const Lattice<3> lattice = test_lattice<3>();
  BodyParameters<3> parameters;
  parameters.density            = 1000.;
  parameters.jitter             = 0.5;
  parameters.shape.lower_corner = lattice.node_position({2, 2, 2});
  parameters.shape.upper_corner = lattice.node_position({7, 7, 7});
  parameters.velocity           = {{1., 0., 2.}};
  parameters.angular_velocity   = {{0., 3., 1.}};
  const auto sums_of            = [&](const unsigned int rank, const unsigned int n_ranks) {
    Body<3> body = empty_body<3>(MechanicalLaw::neo_hookean, false);
    seed_particles(parameters, lattice, 0, rank, n_ranks, body);
    return particle_sums(body, lattice, {{0., 0., -9.81}}, MagnetizationLaw::langevin);
  };
  ParticleSums<3> sums = sums_of(parallel::rank(MPI_COMM_WORLD), parallel::n_ranks(MPI_COMM_WORLD));
  parallel::Reduction reduction;
  sums.for_each_member(reduction);
  reduction.carry_out(MPI_COMM_WORLD);
  CHECK(sums.n_particles == 1000.);
  check_equal(sums, sums_of(0, 1));
}

TEST_CASE("the way since the last solve is that of the particle that went furthest", "[particles]")
{
  // Positions are remembered, then one of three particles goes 0.05 m and another one 0.02 m. Back
  // where it was nothing has been travelled; bodies that are not magnetic do not count.
  const Lattice<2> lattice = test_lattice<2>();
  Random random(5);
  for (const bool is_magnetic : {true, false})
    {
      Body<2> body = empty_body<2>(MechanicalLaw::neo_hookean, is_magnetic);
      add_random_particles(lattice, 2., 8., 3, random, body);
      remember_positions(body);
      CHECK(way_since_solve(body) == 0.);
      const ParticleSet<2> before = body.particles;
      body.particles.component(ParticleProperty::position, 0)[1] += 0.03;
      body.particles.component(ParticleProperty::position, 1)[1] -= 0.04;
      body.particles.component(ParticleProperty::position, 0)[2] -= 0.02;
      CHECK(way_since_solve(body) == Approx(is_magnetic ? 0.05 : 0.).margin(1e-14));
      body.particles = before;
      CHECK(way_since_solve(body) == 0.);
    }
}
