#include <magmpm/lattice/block_set.h>

#include "catch.h"

#include <set>

using namespace magmpm;

TEST_CASE("the blocks around a block are lexicographic, itself in the middle", "[lattice]")
{
  // Neighbour number i + 3 j + 9 k of block b is b + (i, j, k) - (1, 1, 1), by definition.
  const Index<3> block = {-1, 0, 5};
  CHECK(n_neighbours<2> == 9);
  CHECK(n_neighbours<3> == 27);
  CHECK(neighbour_block<3>(block, 13) == block);
  CHECK(neighbour_block<3>(block, 0) == Index<3>{-2, -1, 4});
  CHECK(neighbour_block<3>(block, 14) == Index<3>{0, 0, 5});
  CHECK(neighbour_block<3>(block, 26) == Index<3>{0, 1, 6});
  CHECK(neighbour_block<2>({0, 0}, 5) == Index<2>{1, 0});

  // A block is the opposite neighbour of its neighbours.
  for (int n = 0; n < 27; ++n)
    CHECK(neighbour_block<3>(neighbour_block<3>(block, n), 26 - n) == block);
}

TEST_CASE("keys of blocks differ, also of negative ones and at the limits", "[lattice]")
{
  // A set of keys has as many members as there are blocks, if no two blocks share one; the blocks
  // are those around zero, where signs change, and those at the ends of the documented range.
  const int limit         = 1 << 20;
  const int coordinates[] = {-limit, -limit + 1, -3, -2, -1, 0, 1, 2, limit - 1};
  std::set<std::uint64_t> keys3, keys2;
  for (const int i : coordinates)
    for (const int j : coordinates)
      {
        keys2.insert(block_key<2>({i, j}));
        for (const int k : coordinates)
          keys3.insert(block_key<3>({i, j, k}));
      }
  CHECK(keys2.size() == 81);
  CHECK(keys3.size() == 729);
}

TEST_CASE("a block set finds blocks and the slots around them", "[lattice]")
{
  // Four blocks in an L about the origin, the last one a ghost. Slots are the places in the list;
  // what is not in it has no slot.
  const BlockSet<2> set({{-1, -1}, {0, -1}, {-1, 0}, {5, 5}}, 3);
  CHECK(set.size() == 4);
  CHECK(set.n_owned() == 3);
  for (int s = 0; s < set.size(); ++s)
    CHECK(set.slot(set.block(s)) == s);
  CHECK(set.slot({0, 0}) == invalid_slot);
  CHECK(set.slot({-1, 5}) == invalid_slot);

  // Around (-1, -1): itself in the middle, (0, -1) to its right, (-1, 0) above, nothing else.
  const int nothing = invalid_slot;
  CHECK(set.neighbours(0) ==
        std::array<int, 9>{nothing, nothing, nothing, nothing, 0, 1, nothing, 2, nothing});
  // Around (0, -1): (-1, -1) to its left, (-1, 0) above that.
  CHECK(set.neighbours(1) ==
        std::array<int, 9>{nothing, nothing, nothing, 0, 1, nothing, 2, nothing, nothing});
  // The ghost is alone.
  for (int n = 0; n < 9; ++n)
    CHECK(set.neighbours(3)[n] == (n == 4 ? 3 : nothing));
}

TEST_CASE("an empty block set has nothing in it", "[lattice]")
{
  // A rank without particles has no blocks: both ways of making such a set answer alike.
  for (const BlockSet<3> &set : {BlockSet<3>(), BlockSet<3>({}, 0)})
    {
      CHECK(set.size() == 0);
      CHECK(set.n_owned() == 0);
      CHECK(set.slot({0, 0, 0}) == invalid_slot);
    }
}
