#include <magmpm/mesh/block_partition.h>
#include <magmpm/parallel/reduce.h>

#include "catch.h"
#include "scattered_blocks.h"

#include <algorithm>
#include <set>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  /** A number that belongs to one lane of one node of one block alone. */
  template <int dim>
  double
  signature(const Index<dim> &block, const int node, const int lane)
  {
    double number = 4. * node + lane;
    for (int d = 0; d < dim; ++d)
      number = 100. * number + block[d] + 50.;
    return number;
  }

  /** What should be active: the occupied blocks and all around them. */
  template <int dim>
  std::set<Index<dim>>
  active_blocks(const std::vector<Index<dim>> &occupied)
  {
    std::set<Index<dim>> active;
    for (const Index<dim> &block : occupied)
      for (int n = 0; n < n_neighbours<dim>; ++n)
        active.insert(neighbour_block<dim>(block, n));
    return active;
  }

  /** Each rank owns active blocks that nobody else owns, and has all active ones around them only. */
  template <int dim>
  void
  check_blocks(const BlockSet<dim> &blocks,
               const std::vector<Index<dim>> &occupied,
               const BackgroundMesh<dim> &mesh)
  {
    const std::set<Index<dim>> active = active_blocks<dim>(occupied);
    std::set<Index<dim>> owned, held;
    std::vector<Index<dim>> all;
    for (int slot = 0; slot < blocks.size(); ++slot)
      all.push_back(blocks.block(slot));
    const std::vector<unsigned int> owners = mesh.owners(all);
    int n_wrong                            = 0;
    for (int slot = 0; slot < blocks.size(); ++slot)
      {
        const Index<dim> &block = blocks.block(slot);
        const bool mine         = (owners[slot] == this_rank());
        n_wrong += (active.count(block) == 0 || mine != (slot < blocks.n_owned()));
        held.insert(block);
        if (mine)
          owned.insert(block);
      }
    CHECK(n_wrong == 0);
    CHECK(held.size() == std::size_t(blocks.size()));
    CHECK(parallel::sum(owned.size(), MPI_COMM_WORLD) == active.size());

    std::set<Index<dim>> needed = owned;
    for (const Index<dim> &block : owned)
      for (int n = 0; n < n_neighbours<dim>; ++n)
        {
          const Index<dim> other = neighbour_block<dim>(block, n);
          if (active.count(other) > 0)
            needed.insert(other);
        }
    CHECK(held == needed);
  }

  /**
   * Each rank adds one to all nodes of all blocks around its occupied ones: afterwards the owner of
   * a block must have the number of occupied blocks around it, and after the update ghosts as well.
   */
  template <int dim>
  void
  check_sums(const BlockPartition<dim> &partition,
             const std::vector<Index<dim>> &occupied,
             const std::vector<Index<dim>> &mine)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, NodeContent> field(blocks.size());
    for (const Index<dim> &block : mine)
      for (const int slot : blocks.neighbours(blocks.slot(block)))
        {
          REQUIRE(slot != invalid_slot);
          for (int i = 0; i < field.block_size; ++i)
            field.block(slot)[i] += 1.;
        }

    const std::set<Index<dim>> occupied_set(occupied.begin(), occupied.end());
    const auto count_wrong = [&](const int first, const int end, const bool zero) {
      int n_wrong = 0;
      for (int slot = first; slot < end; ++slot)
        {
          double expected = 0.;
          for (int n = 0; n < n_neighbours<dim> && !zero; ++n)
            expected += occupied_set.count(neighbour_block<dim>(blocks.block(slot), n));
          for (int i = 0; i < field.block_size; ++i)
            n_wrong += (field.block(slot)[i] != expected);
        }
      return n_wrong;
    };
    partition.add_ghosts_to_owners(field);
    CHECK(count_wrong(0, blocks.n_owned(), false) == 0);
    CHECK(count_wrong(blocks.n_owned(), blocks.size(), true) == 0);
    partition.update_ghosts(field);
    CHECK(count_wrong(0, blocks.size(), false) == 0);
  }

  /** Each number of each ghost node must be the one that its owner wrote. */
  template <int dim>
  void
  check_update(const BlockPartition<dim> &partition)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    NodeField<dim, NodeContent> field(blocks.size());
    const auto expected = [&](const int slot, const int i) {
      return signature<dim>(blocks.block(slot), i / n_lanes, i % n_lanes);
    };
    for (int slot = 0; slot < blocks.n_owned(); ++slot)
      for (int i = 0; i < field.block_size; ++i)
        field.block(slot)[i] = expected(slot, i);
    partition.update_ghosts(field);
    int n_wrong = 0;
    for (int slot = 0; slot < blocks.size(); ++slot)
      for (int i = 0; i < field.block_size; ++i)
        n_wrong += (field.block(slot)[i] != expected(slot, i));
    CHECK(n_wrong == 0);
  }

  /** Brings the mesh and the partition to the occupied blocks and checks all of it. */
  template <int dim>
  void
  rebuild_and_check(const std::vector<Index<dim>> &occupied,
                    BackgroundMesh<dim> &mesh,
                    BlockPartition<dim> &partition)
  {
    const std::vector<Index<dim>> given = dealt_out<dim>(occupied);
    mesh.adapt(given, std::vector<unsigned int>(given.size(), 512));
    const std::vector<Index<dim>> mine = owned_of<dim>(occupied, mesh);
    partition.rebuild(mine);
    check_blocks<dim>(partition.blocks(), occupied, mesh);
    check_sums<dim>(partition, occupied, mine);
    check_update<dim>(partition);
  }

  template <int dim>
  MeshParameters<dim>
  mesh_parameters(const bool carries_potential, const bool shielded)
  {
    MeshParameters<dim> parameters;
    parameters.carries_potential = carries_potential;
    parameters.shielded.fill(shielded);
    return parameters;
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("sums and copies over the ranks follow a moving body",
                       "[mesh][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A body of 3^dim blocks walks through the box, jumps, and is rebuilt in place; the exchange
  // pattern changes each time. Sums must count the occupied blocks around each block, and copies
  // bring each number of its owner, whole numbers and so exact.
  for (const bool carries_potential : {false, true})
    {
      BackgroundMesh<dim> mesh(MPI_COMM_WORLD,
                               lattice_of_blocks<dim>(uniform_index<dim>(8)),
                               mesh_parameters<dim>(carries_potential, false));
      BlockPartition<dim> partition(mesh);
      for (const int place : {1, 2, 3, 5, 5, 0})
        {
          Index<dim> lower = uniform_index<dim>(2), upper = uniform_index<dim>(5);
          lower[dim - 1] = place;
          upper[dim - 1] = place + 3;
          rebuild_and_check<dim>(box_of_blocks<dim>(lower, upper), mesh, partition);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("blocks at and beyond the faces of the box have an owner",
                       "[mesh][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Bodies in both corners of the box, occupying the block beyond the lower walls too: there is
  // the base node of a particle within half a cell of the wall. With shielded faces the mesh ends at
  // the wall, and blocks beyond it belong to the owner of the nearest block inside.
  for (const bool shielded : {false, true})
    {
      BackgroundMesh<dim> mesh(MPI_COMM_WORLD,
                               lattice_of_blocks<dim>(uniform_index<dim>(4)),
                               mesh_parameters<dim>(true, shielded));
      BlockPartition<dim> partition(mesh);
      std::vector<Index<dim>> occupied = box_of_blocks<dim>(uniform_index<dim>(-1),
                                                            uniform_index<dim>(1));
      for (const Index<dim> &block :
           box_of_blocks<dim>(uniform_index<dim>(3), uniform_index<dim>(5)))
        occupied.push_back(block);
      rebuild_and_check<dim>(occupied, mesh, partition);

      if (shielded)
        {
          const auto owners =
            mesh.owners({uniform_index<dim>(-1), uniform_index<dim>(0), uniform_index<dim>(-7)});
          CHECK(owners[0] == owners[1]);
          CHECK(owners[2] == owners[1]);
        }
    }
}

TEST_CASE("there may be more ranks than occupied blocks, and none at all", "[mesh][mpi]")
{
  // A single occupied block with two or four ranks, then no particle anywhere, then a block again.
  // All but one rank own no occupied block; some own no active one, and still take part.
  BackgroundMesh<2> mesh(
    MPI_COMM_WORLD, lattice_of_blocks<2>({4, 4}), mesh_parameters<2>(false, false));
  BlockPartition<2> partition(mesh);
  rebuild_and_check<2>({{1, 2}}, mesh, partition);
  rebuild_and_check<2>({}, mesh, partition);
  CHECK(partition.blocks().size() == 0);
  rebuild_and_check<2>({{3, 0}}, mesh, partition);
}

TEST_CASE("two bodies far apart share no ghosts", "[mesh][mpi]")
{
  // Two single blocks in opposite corners of a large box, which the ranks' parts of the mesh divide.
  // Each rank holds the active blocks around its own ones and no other, so the bodies stay strangers.
  BackgroundMesh<2> mesh(
    MPI_COMM_WORLD, lattice_of_blocks<2>({32, 32}), mesh_parameters<2>(true, false));
  BlockPartition<2> partition(mesh);
  rebuild_and_check<2>({{1, 1}, {30, 30}}, mesh, partition);
}
