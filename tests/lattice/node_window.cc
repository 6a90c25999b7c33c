#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/node_field.h>
#include <magmpm/lattice/node_window.h>

#include "catch.h"

#include <set>

using namespace magmpm;

namespace
{
  /** Compares all places of a window round some block with its nodes as integer vectors. */
  template <int dim, int lower, int upper>
  void
  check_window()
  {
    using Window = NodeWindow<dim, lower, upper>;
    Index<dim> block;
    for (int d = 0; d < dim; ++d)
      block[d] = 5 * d - 2;
    int n_wrong = 0;
    for (int i = 0; i < Window::n_nodes; ++i)
      {
        Index<dim> node = node_of_block<dim>(block, 0);
        for (int d = 0, rest = i; d < dim; ++d, rest /= Window::edge)
          node[d] += rest % Window::edge - lower;
        const NodePlace &place = Window::place(i);
        n_wrong += node !=
                   node_of_block<dim>(neighbour_block<dim>(block, place.neighbour), place.node);
        n_wrong += number_in_block<dim>(node) != place.node;
        if (block_of<dim>(node) == block)
          n_wrong += Window::of_block(place.node) != i;
      }
    CHECK(n_wrong == 0);
    CHECK(Window::template box_offsets<3>()[1] == 1);
    CHECK(Window::template box_offsets<3>().back() ==
          2 * (Window::stride(0) + Window::stride(1) + (dim == 3 ? Window::stride(dim - 1) : 0)));
  }

  /** A full box of 3^dim blocks of which the one in the middle is owned, less the last ghost. */
  template <int dim>
  BlockSet<dim>
  block_and_ghosts()
  {
    const Index<dim> middle = {};
    std::vector<Index<dim>> blocks(1, middle);
    for (int n = 0; n < n_neighbours<dim> - 1; ++n)
      if (n != n_neighbours<dim> / 2)
        blocks.push_back(neighbour_block<dim>(middle, n));
    return {blocks, 1};
  }
} // namespace

TEMPLATE_TEST_CASE_SIG("a window knows the blocks of its nodes",
                       "[lattice]",
                       ((int dim), dim),
                       2,
                       3)
{
  // A node as an integer vector belongs to one block and has one number there, which node_of_block()
  // turns back. Windows are those of arenas, filters and images behind walls.
  check_window<dim, 1, 3>();
  check_window<dim, 1, 1>();
  check_window<dim, 3, 0>();
  check_window<dim, 4, 4>();
}

TEMPLATE_TEST_CASE_SIG("loops reach each node once", "[lattice]", ((int dim), dim), 2, 3)
{
  // One owned block and all around it but one: 4^dim nodes are owned, and around a node of the owned
  // block lie 3^dim nodes, less those in the missing block, which is at the upper corner.
  const BlockSet<dim> blocks = block_and_ghosts<dim>();
  std::set<Index<dim>> owned, all;
  const auto node_at = [&](const int slot, const int node) {
    return node_of_block<dim>(blocks.block(slot), node);
  };
  for_nodes(blocks, [&](const int slot, const int node) { owned.insert(node_at(slot, node)); });
  for_nodes_and_ghosts(blocks,
                       [&](const int slot, const int node) { all.insert(node_at(slot, node)); });
  CHECK(int(owned.size()) == nodes_per_block<dim>);
  CHECK(int(all.size()) == (n_neighbours<dim> - 1) * nodes_per_block<dim>);

  for (const int node : {0, 1, nodes_per_block<dim> - 1})
    {
      std::set<Index<dim>> around;
      int n_far = 0;
      for_nodes_around(blocks, 0, node, [&](const int slot, const int other) {
        around.insert(node_at(slot, other));
        for (int d = 0; d < dim; ++d)
          n_far += std::abs(node_at(slot, other)[d] - node_at(0, node)[d]) > 1;
      });
      CHECK(n_far == 0);
      CHECK(int(around.size()) == n_neighbours<dim> - (node == nodes_per_block<dim> - 1 ? 1 : 0));
    }
}

TEMPLATE_TEST_CASE_SIG("a scalar stencil has the weights of B-splines",
                       "[lattice]",
                       ((int dim), dim),
                       2,
                       3)
{
  // Weights sum to one and reproduce the position, and no node is further than 3/2 dx away.
  Lattice<dim> lattice;
  lattice.spacing = 0.125;
  Vector<dim> position;
  for (int d = 0; d < dim; ++d)
    position[d] = 0.7 - 0.411 * d;
  double sum   = 0.;
  int n_nodes  = 0;
  bool is_near = true;
  Vector<dim> mean;
  for_stencil(lattice, position, [&](const Index<dim> &node, const double weight) {
    ++n_nodes;
    sum += weight;
    mean += weight * lattice.node_position(node);
    for (int d = 0; d < dim; ++d)
      is_near = is_near && std::abs(lattice.reduced(position)[d] - node[d]) <= 1.5;
  });
  CHECK(n_nodes == power(stencil_width, dim));
  CHECK(is_near);
  CHECK(sum == Approx(1.).epsilon(1e-15));
  for (int d = 0; d < dim; ++d)
    CHECK(mean[d] == Approx(position[d]).epsilon(1e-14));
}
