#include "../catch.h"

#include <magmpm/parallel/ranks.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/simulation/seeding_report.h>

#include <verification/particles/random_bodies.h>

using namespace magmpm;
using namespace magmpm::verification;

TEST_CASE("bodies are reported beside their shapes", "[simulation][mpi]")
{
  // A box off the lattice, seeded by all ranks, has the numbers of its shape, which are those of a box: in 2D 0.24
  // by 0.5 m, a mass of 240 kg/m and 240 (0.24^2 + 0.5^2)/12 kg m.
  const Lattice<2> lattice = test_lattice<2>();
  BodyParameters<2> parameters;
  parameters.name               = "bar";
  parameters.density            = 2000.;
  parameters.shape.lower_corner = {{0.51, 0.32}};
  parameters.shape.upper_corner = {{0.75, 0.82}};
  std::vector<Body<2>> bodies   = {empty_body<2>(MechanicalLaw::neo_hookean, false)};
  seed_particles(parameters,
                 lattice,
                 0,
                 parallel::rank(MPI_COMM_WORLD),
                 parallel::n_ranks(MPI_COMM_WORLD),
                 bodies[0]);
  CHECK(seeding_report<2>({parameters}, bodies, MPI_COMM_WORLD) ==
        "body            volume [m^2]  mass [kg/m]  centroid [m]  inertia [kg m]\n"
        "  bar, seeded     0.12          240          0.63, 0.57    6.152\n"
        "  bar, its shape  0.12          240          0.63, 0.57    6.152");
}

TEST_CASE("the report tells what compressed fluid fills and weighs", "[simulation][mpi]")
{
  // A box full of fluid that is compressed to J = 0.8 fills what the shape has, 0.1 m^2, and has 1/0.8 of the mass
  // of its undeformed particles, 200 kg/m, and of their inertia, 200 (0.2^2 + 0.5^2 - 2 0.05^2)/12 kg m: they lie
  // 50 mm apart.
  BodyParameters<2> parameters;
  parameters.name               = "pool";
  parameters.density            = 2000.;
  parameters.initial_state      = InitialState::hydrostatic;
  parameters.shape.lower_corner = {{0.5, 0.3}};
  parameters.shape.upper_corner = {{0.7, 0.8}};
  std::vector<Body<2>> bodies   = {empty_body<2>(MechanicalLaw::viscoelastic_fluid, false)};
  ParticleSet<2> &particles     = bodies[0].particles;
  seed_particles(parameters,
                 test_lattice<2>(),
                 0,
                 parallel::rank(MPI_COMM_WORLD),
                 parallel::n_ranks(MPI_COMM_WORLD),
                 bodies[0]);
  for (std::size_t p = 0; p < particles.size(); ++p)
    {
      particles.component(ParticleProperty::deformation, 0)[p] = 0.8;
      particles.component(ParticleProperty::volume, 0)[p] /= 0.8;
    }
  CHECK(seeding_report<2>({parameters}, bodies, MPI_COMM_WORLD) ==
        "body                         volume [m^2]  mass [kg/m]  centroid [m]  inertia [kg m]\n"
        "  pool, seeded                 0.1           250          0.6, 0.55     5.9375\n"
        "  pool, its shape, undeformed  0.1           200          0.6, 0.55     4.83333");
}
