#include <magmpm/lattice/block_set.h>

#include <utility>

namespace magmpm
{
  template <int dim>
  BlockSet<dim>::BlockSet(std::vector<Index<dim>> active_blocks, const int n_owned)
    : blocks(std::move(active_blocks))
    , n_owned_blocks(n_owned)
  {
    slots.reserve(blocks.size());
    for (int s = 0; s < size(); ++s)
      slots.emplace(block_key<dim>(blocks[s]), s);

    neighbour_slots.resize(blocks.size());
    for (int s = 0; s < size(); ++s)
      for (int n = 0; n < n_neighbours<dim>; ++n)
        neighbour_slots[s][n] = slot(neighbour_block<dim>(blocks[s], n));
  }

  template <int dim>
  int
  BlockSet<dim>::slot(const Index<dim> &block) const
  {
    const auto found = slots.find(block_key<dim>(block));
    return found == slots.end() ? invalid_slot : found->second;
  }

  template class BlockSet<2>;
  template class BlockSet<3>;
} // namespace magmpm
