#include <deal.II/distributed/tria.h>

#include <magmpm/mesh/background_mesh.h>
#include <magmpm/parallel/gather.h>
#include <magmpm/parallel/reduce.h>

#include "catch.h"
#include "scattered_blocks.h"

#include <algorithm>
#include <map>
#include <set>

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  /** The box of a mesh in blocks from the lower corner of the mechanical box, and its root cells. */
  template <int dim>
  struct Box
  {
    Index<dim> lower, upper;
    int n_roots;
  };

  template <int dim>
  Box<dim>
  box_of(const BackgroundMesh<dim> &mesh)
  {
    const Lattice<dim> &lattice = mesh.lattice();
    Box<dim> box                = {uniform_index<dim>(1000), uniform_index<dim>(-1000), 0};
    for (const auto &cell : mesh.triangulation().cell_iterators_on_level(0))
      {
        ++box.n_roots;
        for (int d = 0; d < dim; ++d)
          {
            const double block = block_edge * lattice.spacing;
            const double lower = (cell->vertex(0)[d] - lattice.lower_corner[d]) / block;
            const double edge  = cell->extent_in_direction(d) / block;
            // Corners are corners of blocks.
            CHECK(lower == Approx(std::round(lower)).margin(1e-9));
            CHECK(edge == Approx(std::round(edge)).epsilon(1e-9));
            CHECK(edge == Approx(cell->extent_in_direction(0) / block).epsilon(1e-9));
            box.lower[d] = std::min<int>(box.lower[d], std::lround(lower));
            box.upper[d] = std::max<int>(box.upper[d], std::lround(lower + edge));
          }
      }
    return box;
  }

  template <int dim>
  void
  check_box(const Index<dim> &n_blocks,
            const MeshParameters<dim> &parameters,
            const Index<dim> &lower,
            const Index<dim> &upper,
            const int n_roots)
  {
    const BackgroundMesh<dim> mesh(MPI_COMM_SELF, lattice_of_blocks<dim>(n_blocks), parameters);
    const Box<dim> box = box_of(mesh);
    CHECK(box.lower == lower);
    CHECK(box.upper == upper);
    CHECK(box.n_roots == n_roots);
  }

  template <int dim>
  void
  adapt(const std::vector<Index<dim>> &blocks,
        BackgroundMesh<dim> &mesh,
        const unsigned int weight = 512)
  {
    const std::vector<Index<dim>> given = dealt_out<dim>(blocks);
    mesh.adapt(given, std::vector<unsigned int>(given.size(), weight));
  }

  /** The cells of all ranks: by the block that they lie in (or begin in), owners and edge over dx. */
  template <int dim>
  struct Cells
  {
    std::set<unsigned int> owners;
    std::set<int> edges;
    int n = 0;
  };

  template <int dim>
  std::map<Index<dim>, Cells<dim>>
  cells_by_block(const BackgroundMesh<dim> &mesh)
  {
    const Lattice<dim> &lattice = mesh.lattice();
    std::vector<int> mine; // node, edge
    for (const auto &cell : mesh.triangulation().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          for (int d = 0; d < dim; ++d)
            {
              const double node = (cell->vertex(0)[d] - lattice.lower_corner[d]) / lattice.spacing;
              REQUIRE(node == Approx(std::round(node)).margin(1e-9));
              mine.push_back(static_cast<int>(std::lround(node)));
            }
          const double edge = cell->extent_in_direction(0) / lattice.spacing;
          REQUIRE(edge == Approx(std::round(edge)).epsilon(1e-9));
          mine.push_back(static_cast<int>(std::lround(edge)));
        }
    std::map<Index<dim>, Cells<dim>> cells;
    const auto all = parallel::all_gather(mine, MPI_COMM_WORLD);
    for (unsigned int rank = 0; rank < all.size(); ++rank)
      for (std::size_t i = 0; i < all[rank].size(); i += dim + 1)
        {
          Index<dim> node;
          std::copy_n(&all[rank][i], dim, node.begin());
          Cells<dim> &here = cells[block_of<dim>(node)];
          here.owners.insert(rank);
          here.edges.insert(all[rank][i + dim]);
          ++here.n;
        }
    return cells;
  }

  /** All blocks around @p blocks consist of the finest cells, which are on one rank, the owner. */
  template <int dim>
  void
  check_fine_around(const std::vector<Index<dim>> &blocks, const BackgroundMesh<dim> &mesh)
  {
    const int edge = mesh.parameters().cell_edge;
    std::vector<Index<dim>> around;
    for (const Index<dim> &block : blocks)
      for (int n = 0; n < n_neighbours<dim>; ++n)
        around.push_back(neighbour_block<dim>(block, n));
    const std::vector<unsigned int> owners = mesh.owners(around);
    const auto cells                       = cells_by_block(mesh);
    int n_wrong                            = 0;
    for (std::size_t b = 0; b < around.size(); ++b)
      {
        const auto found = cells.find(around[b]);
        n_wrong += (found == cells.end() || found->second.n != power(block_edge / edge, dim) ||
                    found->second.edges != std::set<int>{edge} ||
                    found->second.owners != std::set<unsigned int>{owners[b]});
      }
    CHECK(n_wrong == 0);
  }

  /** A body of 2^dim blocks whose lower corner is at @p place in the first direction. */
  template <int dim>
  std::vector<Index<dim>>
  body_at(const int place)
  {
    Index<dim> lower = uniform_index<dim>(3), upper = uniform_index<dim>(5);
    lower[0] = place;
    upper[0] = place + 2;
    return box_of_blocks<dim>(lower, upper);
  }
} // namespace

TEST_CASE("the potential's box is the smallest of root cells that is large enough", "[mesh]")
{
  // Boxes in units of blocks, worked out by hand: at least twice the mechanical box (or another
  // factor) and two blocks beyond it at each open face, rounded up to one root cell of 2^k blocks.
  MeshParameters<3> parameters;
  check_box<3>({8, 8, 8}, parameters, {-4, -4, -4}, {12, 12, 12}, 1);
  check_box<3>({6, 6, 6}, parameters, {-5, -5, -5}, {11, 11, 11}, 1);
  check_box<3>({1, 1, 1}, parameters, {-3, -3, -3}, {5, 5, 5}, 1);
  parameters.potential_box_factor = 3.;
  check_box<3>({8, 8, 8}, parameters, {-12, -12, -12}, {20, 20, 20}, 1);
  parameters.potential_box_factor = 1.;
  check_box<3>({12, 12, 12}, parameters, {-2, -2, -2}, {14, 14, 14}, 1);
}

TEST_CASE("a long pool has several root cells in a row", "[mesh]")
{
  // Pools of 32 x 8 (x 8) and 20 x 4 blocks: the root cell is the largest power of two within the
  // short direction, and as many of them as cover the long one. 40 blocks take five of 8.
  MeshParameters<3> in_3d;
  check_box<3>({32, 8, 8}, in_3d, {-16, -4, -4}, {48, 12, 12}, 4);
  MeshParameters<2> in_2d;
  check_box<2>({20, 4}, in_2d, {-10, -2}, {30, 6}, 5);
  check_box<2>({4, 20}, in_2d, {-2, -10}, {6, 30}, 5);
}

TEST_CASE("the potential's box ends at shielded walls", "[mesh]")
{
  // At a shielded face the box ends exactly at the wall, on both sides or on one; then all of what
  // is added lies on the open side. Between two shielded walls root cells divide the distance.
  MeshParameters<2> parameters;
  parameters.shielded = {true, true, false, false};
  check_box<2>({12, 8}, parameters, {0, -4}, {12, 12}, 3 * 4);
  check_box<2>({16, 8}, parameters, {0, -4}, {16, 12}, 1);
  parameters.shielded = {true, true, true, false};
  check_box<2>({16, 8}, parameters, {0, 0}, {16, 16}, 1);
  parameters.shielded = {false, true, true, true};
  check_box<2>({8, 16}, parameters, {-8, 0}, {8, 16}, 1);
  parameters.shielded = {true, true, true, true};
  check_box<2>({8, 16}, parameters, {0, 0}, {8, 16}, 2);
  check_box<2>({7, 8}, parameters, {0, 0}, {7, 8}, 56);
}

TEST_CASE("without a potential the mesh is no larger than the mechanical box needs", "[mesh]")
{
  // Nothing is open and nothing is shielded when no potential is solved for: the mesh covers the
  // mechanical box, and its finest cells are blocks, which is all that the partition asks for.
  MeshParameters<3> parameters;
  parameters.carries_potential = false;
  check_box<3>({8, 8, 8}, parameters, {0, 0, 0}, {8, 8, 8}, 1);
  check_box<3>({32, 8, 8}, parameters, {0, 0, 0}, {32, 8, 8}, 4);
  parameters.shielded.fill(true);
  check_box<3>({8, 8, 8}, parameters, {0, 0, 0}, {8, 8, 8}, 1);

  BackgroundMesh<3> mesh(MPI_COMM_WORLD, lattice_of_blocks<3>({8, 8, 8}), parameters);
  adapt<3>(body_at<3>(2), mesh);
  const auto cells = cells_by_block(mesh);
  for (const auto &block : cells)
    CHECK(block.second.n == 1);
  for (const Index<3> &block : body_at<3>(2))
    CHECK(cells.at(block).edges == std::set<int>{block_edge});
}

TEMPLATE_TEST_CASE_SIG("the finest cells cover all active blocks, each on its owner",
                       "[mesh][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A body that moves through the box, jumps, and touches a wall: every block with particles or next
  // to one is made of 2^dim cells of edge 2 dx, or 4^dim of edge dx. p4est keeps a family of 2^dim
  // on one rank, the weights of the cells keep more of them there, and owners() must name it, the
  // same on all ranks.
  for (const int cell_edge : {2, 1})
    {
      MeshParameters<dim> parameters;
      parameters.cell_edge = cell_edge;
      BackgroundMesh<dim> mesh(
        MPI_COMM_WORLD, lattice_of_blocks<dim>(uniform_index<dim>(8)), parameters);
      for (const int place : {1, 2, 4, 0, 6})
        {
          adapt<dim>(body_at<dim>(place), mesh);
          check_fine_around<dim>(body_at<dim>(place), mesh);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("all ranks name the same owner of every block, also outside",
                       "[mesh][mpi]",
                       ((int dim), dim),
                       2,
                       3)
{
  // All blocks from far below the box to far above it, in fine cells, in coarse cells and in none.
  // The answers of all ranks are compared, and each is a rank that exists.
  BackgroundMesh<dim> mesh(
    MPI_COMM_WORLD, lattice_of_blocks<dim>(uniform_index<dim>(8)), MeshParameters<dim>());
  adapt<dim>(body_at<dim>(3), mesh);
  const std::vector<Index<dim>> blocks   = box_of_blocks<dim>(uniform_index<dim>(-7),
                                                            uniform_index<dim>(15));
  const std::vector<unsigned int> owners = mesh.owners(blocks);
  CHECK(*std::max_element(owners.begin(), owners.end()) < n_ranks());
  const auto of_all_ranks = parallel::all_gather(owners, MPI_COMM_WORLD);
  for (const auto &of_rank : of_all_ranks)
    CHECK(of_rank == owners);

  // A block that is a cell, or whose cells are known, belongs to the rank that has them.
  const auto cells = cells_by_block(mesh);
  int n_wrong      = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      const auto found = cells.find(blocks[b]);
      n_wrong += (found != cells.end() && found->second.owners.count(owners[b]) == 0);
    }
  CHECK(n_wrong == 0);
}

TEST_CASE("cells and particles are shared out evenly", "[mesh][mpi]")
{
  // A body of 8 x 4 x 4 blocks with 512 particles each in a box that is mostly empty: the work is 3000
  // a cell of the potential's mesh and 100 a particle (the weights of the mesh), or without a potential
  // the particles alone. No rank may have more than its share and one family of 2^3 cells, which
  // stay together.
  const std::vector<Index<3>> body = box_of_blocks<3>({5, 6, 7}, {13, 10, 11});
  for (const bool carries_potential : {false, true})
    {
      MeshParameters<3> parameters;
      parameters.carries_potential = carries_potential;
      BackgroundMesh<3> mesh(MPI_COMM_WORLD, lattice_of_blocks<3>({16, 16, 16}), parameters);
      adapt<3>(body, mesh);
      double work = 100. * 512. * owned_of<3>(body, mesh).size();
      if (carries_potential)
        work += 3000. * mesh.triangulation().n_locally_owned_active_cells();
      const double most   = parallel::max(work, MPI_COMM_WORLD);
      const double sum    = parallel::sum(work, MPI_COMM_WORLD);
      const double family = (carries_potential ? 8. * 3000. + 100. * 512. : 8. * 100. * 512.);
      CHECK(most <= sum / n_ranks() + family);
    }
}

TEMPLATE_TEST_CASE_SIG("a mesh that serves is left alone", "[mesh]", ((int dim), dim), 2, 3)
{
  // With a band of one block the body may move by a block in any direction before anything changes,
  // without one it may where it was said to go. What is built on the mesh lives from that.
  const Lattice<dim> lattice = lattice_of_blocks<dim>(uniform_index<dim>(12));
  const auto change =
    [](BackgroundMesh<dim> &mesh, const int place, const std::vector<Index<dim>> &approached = {}) {
      const unsigned int revision = mesh.revision();
      const auto blocks           = body_at<dim>(place);
      const bool changed =
        mesh.adapt(blocks, std::vector<unsigned int>(blocks.size(), 512), approached).is_change();
      CHECK(mesh.revision() == revision + (changed ? 1 : 0));
      return changed;
    };
  MeshParameters<dim> parameters;
  parameters.band_width = 1;
  BackgroundMesh<dim> banded(MPI_COMM_WORLD, lattice, parameters);
  CHECK(change(banded, 5));
  for (const int place : {5, 6, 4, 5})
    CHECK_FALSE(change(banded, place));
  CHECK(change(banded, 7));
  for (const int place : {8, 6, 7})
    CHECK_FALSE(change(banded, place));

  BackgroundMesh<dim> tight(MPI_COMM_WORLD, lattice, MeshParameters<dim>());
  CHECK(change(tight, 3));
  CHECK(change(tight, 4));
  CHECK_FALSE(change(tight, 4));
  CHECK(change(tight, 5, body_at<dim>(7)));
  for (const int place : {6, 7, 6, 5})
    CHECK_FALSE(change(tight, place));
  CHECK(change(tight, 8));
}

TEMPLATE_TEST_CASE_SIG("a body that crosses the box leaves no fine cells behind",
                       "[mesh]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Cells of the mesh while a body goes from wall to wall and back. Those it leaves are coarsened
  // again, so there are never more than two and a half times as many as around a body at rest.
  BackgroundMesh<dim> mesh(
    MPI_COMM_WORLD, lattice_of_blocks<dim>(uniform_index<dim>(24)), MeshParameters<dim>());
  unsigned int least = 0, most = 0;
  for (int i = 0; i < 44; ++i)
    {
      adapt<dim>(body_at<dim>(i < 22 ? i : 44 - i), mesh);
      const unsigned int n = mesh.triangulation().n_global_active_cells();
      least                = (i == 0 ? n : std::min(least, n));
      most                 = std::max(most, n);
    }
  CAPTURE(least, most);
  CHECK(most < 2.5 * least);
}
