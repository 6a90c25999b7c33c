#include <magmpm/parallel/gather.h>
#include <magmpm/particles/particle_migration.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

#include <algorithm>
#include <numeric>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  constexpr int n_particles = 1000; ///< of all ranks

  unsigned int
  this_rank()
  {
    return parallel::rank(MPI_COMM_WORLD);
  }

  unsigned int
  n_ranks()
  {
    return parallel::n_ranks(MPI_COMM_WORLD);
  }

  /** A number that belongs to one component of one particle alone, all digits used. */
  double
  signature(const std::uint64_t id, const int quantity, const int component)
  {
    return std::sqrt(2. + 100. * id + 10. * quantity + component);
  }

  /** Particles with ids first, first + 1, ... */
  template <int dim>
  ParticleSet<dim>
  signed_particles(const Body<dim> &body, const std::uint64_t first, const std::size_t n)
  {
    ParticleSet<dim> particles = body.particles;
    particles.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      {
        particles.ids()[p] = first + p;
        for (int q = 0; q < n_particle_properties; ++q)
          for (int c = 0; c < particles.n_components(ParticleProperty(q)); ++c)
            particles.component(ParticleProperty(q), c)[p] = signature(first + p, q, c);
      }
    return particles;
  }

  template <int dim>
  int
  count_changed_values(const ParticleSet<dim> &particles)
  {
    int n_changed = 0;
    for (std::size_t p = 0; p < particles.size(); ++p)
      for (int q = 0; q < n_particle_properties; ++q)
        for (int c = 0; c < particles.n_components(ParticleProperty(q)); ++c)
          n_changed += (particles.component(ParticleProperty(q), c)[p] !=
                        signature(particles.ids()[p], q, c));
    return n_changed;
  }

  /** The ids of all ranks together, sorted. */
  template <int dim>
  std::vector<std::uint64_t>
  all_ids(const ParticleSet<dim> &particles)
  {
    std::vector<std::uint64_t> ids;
    for (const auto &of_rank : parallel::all_gather(particles.ids(), MPI_COMM_WORLD))
      ids.insert(ids.end(), of_rank.begin(), of_rank.end());
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  /** Where a particle is sent in a round; the last round sends all to the last rank. */
  unsigned int
  destination_of(const std::uint64_t id, const unsigned int round)
  {
    return round == 3 ? n_ranks() - 1 : (id * id / 7 + round * id) % n_ranks();
  }

  template <int dim>
  void
  check_migration(const Body<dim> &body)
  {
    // At first rank 0 has all of them, the others none.
    ParticleSet<dim> particles = signed_particles(body, 0, this_rank() == 0 ? n_particles : 0);
    for (unsigned int round = 0; round < 4; ++round)
      {
        std::vector<unsigned int> destination;
        for (const std::uint64_t id : particles.ids())
          destination.push_back(destination_of(id, round));
        const std::size_t n_leaving =
          particles.size() - std::count(destination.begin(), destination.end(), this_rank());
        CHECK(migrate_particles<dim>(MPI_COMM_WORLD, {destination}, {&particles}) == n_leaving);

        int n_astray = 0;
        for (const std::uint64_t id : particles.ids())
          n_astray += (destination_of(id, round) != this_rank());
        CHECK(n_astray == 0);
        CHECK(count_changed_values(particles) == 0);
        std::vector<std::uint64_t> expected(n_particles);
        std::iota(expected.begin(), expected.end(), 0);
        CHECK(all_ids(particles) == expected);
      }
  }
} // namespace

TEST_CASE("migration loses, doubles and changes no particle", "[particles][mpi]")
{
  // A thousand particles, each number of each of them different, go from rank 0 to all ranks, to
  // other ones, and to the last one. Afterwards each is on the rank it was sent to, once, and its
  // numbers are the same to the last bit, for solids and fluids with and without magnetic content.
  check_migration(empty_body<2>(MechanicalLaw::neo_hookean, true));
  check_migration(empty_body<3>(MechanicalLaw::neo_hookean, true));
  check_migration(empty_body<3>(MechanicalLaw::viscoelastic_fluid, false));
}

TEST_CASE("migration to where particles are moves nothing", "[particles][mpi]")
{
  // All particles stay, so none is sent and the order remains: what is sorted stays sorted.
  const Body<2> body       = empty_body<2>(MechanicalLaw::neo_hookean, false);
  ParticleSet<2> particles = signed_particles(body, 10 * this_rank(), 10);
  const auto ids           = particles.ids();
  const std::vector<unsigned int> destination(10, this_rank());
  CHECK(migrate_particles<2>(MPI_COMM_WORLD, {destination}, {&particles}) == 0);
  CHECK(particles.ids() == ids);
  CHECK(count_changed_values(particles) == 0);
}

TEST_CASE("the particles of all bodies migrate together", "[particles][mpi]")
{
  // Four bodies: a fluid, a magnetic solid, one without particles on any rank, and one whose particles
  // all stay. Records are of other lengths in each, and particles of a rank for another one may be of
  // two bodies or of none: afterwards each body has its own particles, all on their ranks.
  const Body<3> fluid              = empty_body<3>(MechanicalLaw::viscoelastic_fluid, false);
  const Body<3> solid              = empty_body<3>(MechanicalLaw::neo_hookean, true);
  std::vector<ParticleSet<3>> sets = {signed_particles(fluid, 100 * this_rank(), 100),
                                      signed_particles(solid, 30 * this_rank(), 30),
                                      signed_particles(solid, 0, 0),
                                      signed_particles(fluid, 10 * this_rank(), 10)};
  std::vector<std::vector<unsigned int>> destinations(4);
  for (int s = 0; s < 2; ++s)
    for (const std::uint64_t id : sets[s].ids())
      destinations[s].push_back(destination_of(id, s));
  destinations[3].assign(10, this_rank());
  migrate_particles<3>(MPI_COMM_WORLD, destinations, {&sets[0], &sets[1], &sets[2], &sets[3]});

  for (int s = 0; s < 2; ++s)
    {
      CHECK(count_changed_values(sets[s]) == 0);
      for (const std::uint64_t id : sets[s].ids())
        CHECK(destination_of(id, s) == this_rank());
      std::vector<std::uint64_t> expected((s == 0 ? 100 : 30) * n_ranks());
      std::iota(expected.begin(), expected.end(), 0);
      CHECK(all_ids(sets[s]) == expected);
    }
  CHECK(sets[2].size() == 0);
  CHECK(sets[3].size() == 10);
  CHECK(count_changed_values(sets[3]) == 0);
}
