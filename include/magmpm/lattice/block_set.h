#pragma once

#include <magmpm/lattice/lattice.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace magmpm
{
  /** Blocks around a block, itself included: lexicographic, the middle one is the block. */
  template <int dim>
  inline constexpr int n_neighbours = power(3, dim);

  /** Stands for a block that is not active. */
  inline constexpr int invalid_slot = -1;

  /**
   * The active blocks of this rank, each with a slot (its place in every NodeField): first the ones
   * this rank owns, then ghosts that belong to other ranks.
   */
  template <int dim>
  class BlockSet
  {
  public:
    BlockSet() = default;

    BlockSet(std::vector<Index<dim>> blocks, const int n_owned);

    int
    n_owned() const
    {
      return n_owned_blocks;
    }

    /** Owned and ghost blocks. */
    int
    size() const
    {
      return static_cast<int>(blocks.size());
    }

    const Index<dim> &
    block(const int slot) const
    {
      return blocks[slot];
    }

    /** The slot of a block, or invalid_slot. */
    int
    slot(const Index<dim> &block) const;

    /** Slots of the blocks around @p slot in lexicographic order (x fastest), or invalid_slot. */
    const std::array<int, n_neighbours<dim>> &
    neighbours(const int slot) const
    {
      return neighbour_slots[slot];
    }

  private:
    std::vector<Index<dim>> blocks;
    int n_owned_blocks = 0;
    std::unordered_map<std::uint64_t, int> slots;
    std::vector<std::array<int, n_neighbours<dim>>> neighbour_slots;
  };

  /** The block next to @p block in the lexicographic direction @p neighbour (0 .. 3^dim - 1). */
  template <int dim>
  inline Index<dim>
  neighbour_block(const Index<dim> &block, int neighbour)
  {
    Index<dim> result;
    for (int d = 0; d < dim; ++d, neighbour /= 3)
      result[d] = block[d] + neighbour % 3 - 1;
    return result;
  }

  /** An integer that is different for different blocks (coordinates within +-2^20). */
  template <int dim>
  inline std::uint64_t
  block_key(const Index<dim> &block)
  {
    std::uint64_t key = 0;
    for (int d = dim - 1; d >= 0; --d)
      key = (key << 21) | static_cast<std::uint64_t>(block[d] + (1 << 20));
    return key;
  }
} // namespace magmpm
