#include <magmpm/particles/particle_sort.h>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace magmpm
{
  template <int dim>
  OccupiedBlocks<dim>
  occupied_blocks(const std::vector<Body<dim>> &bodies,
                  const Lattice<dim> &lattice,
                  const bool with_force_margin)
  {
    std::unordered_map<std::uint64_t, unsigned int> counts;
    OccupiedBlocks<dim> occupied;
    const auto count = [&](const Index<dim> &node, const unsigned int n_particles) {
      const Index<dim> block     = block_of<dim>(node);
      const auto [entry, is_new] = counts.emplace(block_key<dim>(block), 0);
      entry->second += n_particles;
      if (is_new)
        occupied.blocks.push_back(block);
    };
    for (const Body<dim> &body : bodies)
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          Index<dim> node = lattice.base_node(body.particles.position(p));
          count(node, 1);
          if (with_force_margin && body.magnetic.is_magnetic())
            {
              for (int &coordinate : node)
                ++coordinate;
              count(node, 0);
            }
        }
    std::sort(occupied.blocks.begin(), occupied.blocks.end());
    for (const Index<dim> &block : occupied.blocks)
      occupied.n_particles.push_back(counts[block_key<dim>(block)]);
    return occupied;
  }

  template <int dim>
  void
  sort_into_blocks(const BlockSet<dim> &blocks, const Lattice<dim> &lattice, Body<dim> &body)
  {
    // Counting sort by slot and cell; places within a block are the 4^dim base nodes.
    const std::size_t n_particles  = body.particles.size();
    const std::size_t n_slots      = blocks.n_owned();
    constexpr std::size_t n_places = nodes_per_block<dim>;
    std::vector<std::uint32_t> key(n_particles), order(n_particles);
    std::vector<std::size_t> begin(n_slots * n_places + 1, 0);
    for (std::size_t p = 0; p < n_particles; ++p)
      {
        const Index<dim> node  = lattice.base_node(body.particles.position(p));
        const Index<dim> block = block_of<dim>(node);
        const int slot         = blocks.slot(block);
        assert(slot != invalid_slot && slot < blocks.n_owned());
        int place = 0;
        for (int d = dim - 1; d >= 0; --d)
          place = place * block_edge + node[d] - block_edge * block[d];
        key[p] = static_cast<std::uint32_t>(slot * n_places + place);
        ++begin[key[p] + 1];
      }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());

    body.run_begin.resize(n_slots + 1);
    for (std::size_t slot = 0; slot <= n_slots; ++slot)
      body.run_begin[slot] = begin[slot * n_places];
    for (std::size_t p = 0; p < n_particles; ++p)
      order[begin[key[p]]++] = static_cast<std::uint32_t>(p);
    body.particles.reorder(order);
  }

#define INSTANTIATE(dim)                                               \
  template OccupiedBlocks<dim> occupied_blocks(                        \
    const std::vector<Body<dim>> &, const Lattice<dim> &, const bool); \
  template void sort_into_blocks(const BlockSet<dim> &, const Lattice<dim> &, Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
