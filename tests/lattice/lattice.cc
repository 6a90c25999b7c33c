#include <magmpm/lattice/bspline.h>
#include <magmpm/lattice/lattice.h>
#include <magmpm/lattice/node_field.h>

#include "catch.h"

using namespace magmpm;

namespace
{
  /** dx = 1/8 and corners in binary fractions: positions and their reductions are exact. */
  const Lattice<3> lattice = {{{-1., 0.5, 0.25}}, 0.125, {8, 16, 4}};
} // namespace

TEST_CASE("blocks of negative nodes are rounded down", "[lattice]")
{
  // floor(node/4) on both sides of zero, where a division in C would round towards zero and put
  // eight nodes in block 0.
  for (int node = -13; node < 14; ++node)
    {
      const int block = block_of<2>({node, 0})[0];
      CHECK(4 * block <= node);
      CHECK(node < 4 * (block + 1));
    }
  CHECK(block_of<3>({-1, -4, -5}) == Index<3>{-1, -1, -2});
  CHECK(block_of<3>({0, 3, 4}) == Index<3>{0, 0, 1});
}

TEST_CASE("nodes sit where lower corner and spacing put them", "[lattice]")
{
  // Positions of nodes and back, for nodes inside and outside of the box; exact in binary.
  const Vector<3> position = lattice.node_position({3, -2, 0});
  CHECK(position[0] == -0.625);
  CHECK(position[1] == 0.25);
  CHECK(position[2] == 0.25);
  CHECK(lattice.upper_corner()[0] == 0.);
  CHECK(lattice.upper_corner()[1] == 2.5);
  CHECK(lattice.reduced(position)[1] == -2.);
  for (int i = -5; i < 5; ++i)
    CHECK(lattice.nearest_node(lattice.node_position({i, 2 * i, -i})) == Index<3>{i, 2 * i, -i});
  // (3.44, 0.48, -0.4) and (3.52, -1.52, 0) in units of dx.
  CHECK(lattice.nearest_node({{-0.57, 0.56, 0.2}}) == Index<3>{3, 0, 0});
  CHECK(lattice.nearest_node({{-0.56, 0.31, 0.25}}) == Index<3>{4, -2, 0});
}

TEST_CASE("the base node is the first of the three whose B-splines reach a point", "[lattice]")
{
  // The offset from the base node lies in [1/2, 3/2), the range of quadratic_bspline(), also for
  // points on either side of the lower corner and exactly between nodes.
  for (double x = -1.5; x < 0.5; x += 1. / 128.)
    {
      const Vector<3> point = {{x, 0.5, 0.25}};
      const Index<3> base   = lattice.base_node(point);
      const double offset   = lattice.reduced(point)[0] - base[0];
      CHECK(offset >= 0.5);
      CHECK(offset < 1.5);
      CHECK(base[1] == -1);
    }
}

TEST_CASE("B-splines on the lattice interpolate a linear function exactly", "[lattice]")
{
  // Base node, weights and node positions together, as a transfer uses them: the interpolant of a
  // linear function is that function for every B-spline, so only rounding may differ.
  const auto linear     = [](const Vector<3> &x) { return 3. - x[0] + 2. * x[1] + 5. * x[2]; };
  const Vector<3> point = {{-0.987, 0.51, 1.2345}};
  const Index<3> base   = lattice.base_node(point);

  double weights[3][stencil_width];
  for (int d = 0; d < 3; ++d)
    quadratic_bspline(lattice.reduced(point)[d] - base[d], weights[d]);

  double interpolant = 0.;
  for (int k = 0; k < stencil_width; ++k)
    for (int j = 0; j < stencil_width; ++j)
      for (int i = 0; i < stencil_width; ++i)
        interpolant += weights[0][i] * weights[1][j] * weights[2][k] *
                       linear(lattice.node_position({base[0] + i, base[1] + j, base[2] + k}));
  CHECK(interpolant == Approx(linear(point)).epsilon(1e-14));
}

TEST_CASE("the nodes of a block are numbered with x fastest", "[lattice]")
{
  // Number n = i + 4 j + 16 k of block b is node 4 b + (i, j, k), which lies in that block again.
  const Index<3> block = {-2, 0, 3};
  for (int n = 0; n < nodes_per_block<3>; ++n)
    {
      const Index<3> node = node_of_block<3>(block, n);
      CHECK(block_of<3>(node) == block);
      CHECK((node[0] + 8) + 4 * node[1] + 16 * (node[2] - 12) == n);
    }
  CHECK(nodes_per_block<2> == 16);
  CHECK(node_of_block<2>({1, -1}, 6) == Index<2>{6, -3});
}

TEST_CASE("the lanes of a node field do not overlap", "[lattice]")
{
  // A different number in every lane of every node, read back through the pointer of its block: 0
  // to 191 for 3 blocks, 16 nodes, 4 lanes. Their sum is 191 * 192/2 only if no two share a place.
  NodeField<2> field;
  field.reinit(3);
  CHECK(field.n_blocks() == 3);
  double value = 0.;
  for (int slot = 0; slot < 3; ++slot)
    for (int node = 0; node < nodes_per_block<2>; ++node)
      for (int lane = 0; lane < n_lanes; ++lane)
        field.node(slot, node)[lane] = value++;

  double sum = 0.;
  for (int slot = 0; slot < 3; ++slot)
    for (int i = 0; i < NodeField<2>::block_size; ++i)
      sum += field.block(slot)[i];
  CHECK(sum == 191. * 192. / 2.);
  CHECK(field.node(2, 5)[3] == (2 * 16 + 5) * 4 + 3);

  field.set_zero();
  CHECK(field.node(2, 5)[3] == 0.);
}
