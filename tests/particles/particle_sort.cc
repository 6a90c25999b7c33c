#include <magmpm/particles/particle_sort.h>

#include "catch.h"

#include <verification/particles/random_bodies.h>

#include <limits>
#include <map>
#include <set>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** All numbers of each particle, by id. */
  template <int dim>
  std::map<std::uint64_t, std::vector<double>>
  records(const ParticleSet<dim> &particles)
  {
    std::map<std::uint64_t, std::vector<double>> by_id;
    for (std::size_t p = 0; p < particles.size(); ++p)
      particles.append_record(p, by_id[particles.ids()[p]]);
    return by_id;
  }

  template <int dim>
  Index<dim>
  base_node(const Body<dim> &body, const Lattice<dim> &lattice, const std::size_t p)
  {
    return lattice.base_node(body.particles.position(p));
  }

  template <int dim>
  int
  place_in_block(const Index<dim> &node)
  {
    int place = 0;
    for (int d = dim - 1; d >= 0; --d)
      place = block_edge * place + (node[d] & (block_edge - 1));
    return place;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("occupied blocks are those of the particles' base nodes",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Blocks and counts against a count particle by particle; the two bodies of 200 particles share
  // some blocks. The order is sorted, so that it does not depend on that of the particles.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  std::map<Index<dim>, unsigned int> expected;
  for (const Body<dim> &body : bodies)
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      ++expected[block_of<dim>(base_node(body, lattice, p))];

  const OccupiedBlocks<dim> occupied = occupied_blocks(bodies, lattice);
  REQUIRE(occupied.blocks.size() == expected.size());
  REQUIRE(occupied.n_particles.size() == expected.size());
  CHECK(std::is_sorted(occupied.blocks.begin(), occupied.blocks.end()));
  for (std::size_t b = 0; b < occupied.blocks.size(); ++b)
    CHECK(occupied.n_particles[b] == expected[occupied.blocks[b]]);
}

TEMPLATE_TEST_CASE_SIG("approached blocks are those on the particles' way",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // All particles fly 10 cells along x and 3 along y: a block is approached if and only if it has the
  // base node of one of them at a third, two thirds or the end of that way, which is 10.4 cells long.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  Vector<dim> way;
  way[0] = 10. * lattice.spacing;
  way[1] = 3. * lattice.spacing;
  std::set<Index<dim>> expected;
  for (Body<dim> &body : bodies)
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      {
        for (int d = 0; d < dim; ++d)
          body.particles.component(ParticleProperty::velocity, d)[p] = way[d] / 0.5;
        for (const double part : {1. / 3., 2. / 3., 1.})
          expected.insert(
            block_of<dim>(lattice.base_node(body.particles.position(p) + part * way)));
      }
  const std::vector<Index<dim>> approached = approached_blocks<dim>(bodies, lattice, 0.5);
  CHECK(approached == std::vector<Index<dim>>(expected.begin(), expected.end()));
}

TEMPLATE_TEST_CASE_SIG("sorting brings each particle into the run of its block",
                       "[particles]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Every particle of run s has its base node in the block of slot s, runs follow each other without
  // a gap, and within a run cells are in order. No particle is lost or changed by it: sorted by id,
  // all their numbers are the same to the last bit.
  const Lattice<dim> lattice    = test_lattice<dim>();
  std::vector<Body<dim>> bodies = random_bodies(lattice);
  const BlockSet<dim> blocks    = active_blocks(bodies, lattice);
  for (Body<dim> &body : bodies)
    {
      const auto before = records(body.particles);
      sort_into_blocks(blocks, lattice, body);
      CHECK(records(body.particles) == before);

      REQUIRE(body.run_begin.size() == std::size_t(blocks.n_owned()) + 1);
      CHECK(body.run_begin.front() == 0);
      CHECK(body.run_begin.back() == body.particles.size());
      int n_misplaced = 0, n_out_of_order = 0;
      for (int slot = 0; slot < blocks.n_owned(); ++slot)
        {
          REQUIRE(body.run_begin[slot] <= body.run_begin[slot + 1]);
          int place = 0;
          for (std::size_t p = body.run_begin[slot]; p < body.run_begin[slot + 1]; ++p)
            {
              const Index<dim> node = base_node(body, lattice, p);
              n_misplaced += (block_of<dim>(node) != blocks.block(slot));
              n_out_of_order += (place_in_block<dim>(node) < place);
              place = place_in_block<dim>(node);
            }
        }
      CHECK(n_misplaced == 0);
      CHECK(n_out_of_order == 0);
    }
}

TEST_CASE("sorting again changes nothing, and a body without particles has empty runs",
          "[particles]")
{
  // The sort is stable, so the order of a sorted body is a fixed point. Without particles there is
  // still one run for each owned block.
  const Lattice<3> lattice    = test_lattice<3>();
  std::vector<Body<3>> bodies = random_bodies(lattice);
  const BlockSet<3> blocks    = active_blocks(bodies, lattice);
  sort_into_blocks(blocks, lattice, bodies[0]);
  const std::vector<std::uint64_t> ids = bodies[0].particles.ids();
  sort_into_blocks(blocks, lattice, bodies[0]);
  CHECK(bodies[0].particles.ids() == ids);

  Body<3> nothing = empty_body<3>(MechanicalLaw::neo_hookean, false);
  sort_into_blocks(blocks, lattice, nothing);
  CHECK(nothing.run_begin == std::vector<std::size_t>(blocks.n_owned() + 1, 0));
}
