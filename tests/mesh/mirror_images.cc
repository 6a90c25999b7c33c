#include <magmpm/lattice/node_window.h>
#include <magmpm/mesh/block_partition.h>

#include "catch.h"
#include "scattered_blocks.h"

using namespace magmpm;
using namespace magmpm::testing;

namespace
{
  constexpr int n_cells = 16;

  /** A scalar and a vector, with a lane between them that nobody uses. */
  struct Quantities
  {
    static constexpr NodeScalar<Quantities> density  = {0};
    static constexpr NodeVector<Quantities> velocity = {2};

    template <typename Function>
    static constexpr void
    for_each(Function &&f)
    {
      f(density);
      f(velocity);
    }
  };

  /** A full box with mirrors on all sides, spread over the ranks. */
  template <int dim>
  struct BoxOfMirrors
  {
    BoxOfMirrors()
      : mesh(MPI_COMM_WORLD, lattice_of_blocks<dim>(uniform_index<dim>(n_cells / 4)), parameters())
      , partition(mesh)
    {
      const auto occupied = box_of_blocks<dim>(uniform_index<dim>(0),
                                               uniform_index<dim>(n_cells / 4));
      const auto given    = dealt_out<dim>(occupied);
      mesh.adapt(given, std::vector<unsigned int>(given.size(), 512));
      partition.rebuild(owned_of<dim>(occupied, mesh));
    }

    static MeshParameters<dim>
    parameters()
    {
      MeshParameters<dim> parameters;
      parameters.shielded.fill(true);
      return parameters;
    }

    Index<dim>
    node(const int slot, const int number) const
    {
      return node_of_block<dim>(partition.blocks().block(slot), number);
    }

    BackgroundMesh<dim> mesh;
    BlockPartition<dim> partition;
  };

  /** A number for each node and lane. */
  template <int dim>
  double
  number(const Index<dim> &node, const int lane)
  {
    double result = 1. + lane;
    for (int d = 0; d < dim; ++d)
      result = 40. * result + node[d];
    return result;
  }

  /** The coordinate of the image in front of the walls, and how many walls are between. */
  std::pair<int, int>
  in_front(const int node)
  {
    return node < 0
             ? std::make_pair(-node, 1)
             : (node > n_cells ? std::make_pair(2 * n_cells - node, 1) : std::make_pair(node, 0));
  }

  /** What a mirror makes of number() at a node; @p is_odd by axis. */
  template <int dim>
  double
  image(const Index<dim> &node, const int lane, const std::array<bool, dim> &is_odd)
  {
    Index<dim> front;
    double sign = 1.;
    for (int d = 0; d < dim; ++d)
      {
        const auto [coordinate, n_walls] = in_front(node[d]);
        front[d]                         = coordinate;
        if (is_odd[d])
          sign *= (coordinate == 0 || coordinate == n_cells ? 0. : (n_walls == 0 ? 1. : -1.));
      }
    return sign * number<dim>(front, lane);
  }

  /** Nodes that the image of nothing reaches: further than three behind a wall. */
  template <int dim>
  bool
  is_far(const Index<dim> &node)
  {
    return std::any_of(node.begin(), node.end(), [](const int i) {
      return i < -3 || i > n_cells + 3;
    });
  }
} // namespace

// Nodes behind walls, and ghosts, must have the numbers of those in front with the sign that parity
// gives them: whole numbers, so exact. In corners the signs of all walls multiply.
TEMPLATE_TEST_CASE_SIG("Ghosts behind mirrors are images", "[mesh][mpi]", ((int dim), dim), 2, 3)
{
  const BoxOfMirrors<dim> box;
  const Parity stick          = {Parity::even, Parity::odd};
  const BlockSet<dim> &blocks = box.partition.blocks();
  for (const Parity &parity : {Parity(), stick, Parity{Parity::odd, Parity::even}})
    {
      NodeField<dim, Quantities> field(blocks.size());
      for_nodes(blocks, [&](const int slot, const int n) {
        const Index<dim> node = box.node(slot, n);
        bool is_inside        = true;
        for (int d = 0; d < dim; ++d)
          is_inside = is_inside && in_front(node[d]).second == 0;
        Vector<dim> vector;
        for (int d = 0; d < dim; ++d)
          vector[d] = (is_inside ? number<dim>(node, 2 + d) : 1e10);
        field.set(Quantities::velocity, slot, n, vector);
        field.set(Quantities::density, slot, n, is_inside ? number<dim>(node, 0) : 1e10);
      });
      box.partition.update_ghosts(field, parity);

      int n_wrong = 0;
      for_nodes_and_ghosts(blocks, [&](const int slot, const int n) {
        const Index<dim> node = box.node(slot, n);
        if (is_far<dim>(node))
          return;
        std::array<bool, dim> is_odd;
        is_odd.fill(parity.scalars == Parity::odd);
        n_wrong += field.get(Quantities::density, slot, n) != image<dim>(node, 0, is_odd);
        for (int c = 0; c < dim; ++c)
          {
            for (int d = 0; d < dim; ++d)
              is_odd[d] = (parity.vectors == Parity::odd ||
                           (parity.vectors == Parity::odd_normal && c == d));
            n_wrong += field.get(Quantities::velocity, slot, n)[c] !=
                       image<dim>(node, 2 + c, is_odd);
          }
      });
      CHECK(n_wrong == 0);
    }
}

// P2G of material in front of a mirror, with its image behind, is a field that the mirror leaves as it
// is: what particles gave to nodes behind comes back in front, on the wall it counts twice. A constant
// of 1 in the whole box and one node behind it is 2 there, and where two walls meet, 4.
TEMPLATE_TEST_CASE_SIG("Sums take in the images", "[mesh][mpi]", ((int dim), dim), 2, 3)
{
  const BoxOfMirrors<dim> box;
  const BlockSet<dim> &blocks = box.partition.blocks();
  NodeField<dim, Quantities> field(blocks.size());
  for_nodes(blocks, [&](const int slot, const int n) {
    const Index<dim> node = box.node(slot, n);
    const bool is_reached = std::all_of(node.begin(), node.end(), [](const int i) {
      return i >= -1 && i <= n_cells + 1;
    });
    Vector<dim> vector;
    for (int d = 0; d < dim; ++d)
      vector[d] = is_reached;
    field.set(Quantities::density, slot, n, is_reached);
    field.set(Quantities::velocity, slot, n, vector);
  });
  box.partition.add_ghosts_to_owners(field, Parity());
  int n_wrong = 0;
  for_nodes(blocks, [&](const int slot, const int n) {
    const Index<dim> node = box.node(slot, n);
    double density        = 1.;
    Vector<dim> velocity  = field.get(Quantities::velocity, slot, n);
    bool is_near          = true;
    for (int d = 0; d < dim; ++d)
      {
        const int from_wall = std::min(std::abs(node[d]), std::abs(node[d] - n_cells));
        is_near             = is_near && node[d] >= -1 && node[d] <= n_cells + 1;
        density *= (from_wall <= 1 ? 2. : 1.);
        if (from_wall <= 1) // f - f on both nodes and on the wall
          n_wrong += is_near && velocity[d] != 0.;
      }
    n_wrong += is_near && field.get(Quantities::density, slot, n) != density;
  });
  CHECK(n_wrong == 0);
}

TEST_CASE("an exchange sends the lanes that hold something", "[mesh][mpi]")
{
  // Lane 1 of the list is nobody's: what lies there stays where it is. The count of lanes is that of
  // the quantities: one scalar and two components.
  const BoxOfMirrors<2> box;
  const BlockSet<2> &blocks = box.partition.blocks();
  NodeField<2, Quantities> field(blocks.size());
  for_nodes(blocks, [&](const int slot, const int n) {
    std::fill_n(field.node(slot, n), field.width, 1.);
  });
  box.partition.update_ghosts(field);
  int n_wrong = 0;
  for (int slot = blocks.n_owned(); slot < blocks.size(); ++slot)
    for (int n = 0; n < nodes_per_block<2>; ++n)
      for (int lane = 0; lane < field.width; ++lane)
        n_wrong += field.node(slot, n)[lane] != (lane == 1 ? 0. : 1.);
  CHECK(n_wrong == 0);
  CHECK(box.partition.exchanges().n_exchanges == 1);
  CHECK(box.partition.exchanges().n_lanes == 3);
}
