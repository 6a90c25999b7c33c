#include <magmpm/particles/particle_sort.h>

#include <algorithm>
#include <cassert>
#include <numeric>

namespace magmpm
{
  namespace
  {
    /** Collects blocks and counts particles in them. */
    template <int dim>
    class BlockCount
    {
    public:
      explicit BlockCount(const bool with_force_margin)
        : with_force_margin(with_force_margin)
      {
      }

      /** A particle with this base node. */
      void
      add(Index<dim> node, const bool is_magnetic)
      {
        ++count_of(block_of<dim>(node), last);
        if (with_force_margin && is_magnetic)
          {
            for (int &coordinate : node)
              ++coordinate;
            count_of(block_of<dim>(node), last_of_margin);
          }
      }

      OccupiedBlocks<dim>
      sorted()
      {
        OccupiedBlocks<dim> occupied;
        std::sort(blocks.begin(), blocks.end());
        for (const Index<dim> &block : blocks)
          occupied.n_particles.push_back(counts[block_key<dim>(block)]);
        occupied.blocks = std::move(blocks);
        return occupied;
      }

    private:
      /** The block of the particle before, which is mostly that of the next one too. */
      struct Last
      {
        Index<dim> block    = {};
        unsigned int *count = nullptr;
      };

      unsigned int &
      count_of(const Index<dim> &block, Last &last)
      {
        if (last.count == nullptr || last.block != block)
          {
            const auto [entry, is_new] = counts.try_emplace(block_key<dim>(block), 0);
            if (is_new)
              blocks.push_back(block);
            last = {block, &entry->second};
          }
        return *last.count;
      }

      const bool with_force_margin;
      Last last, last_of_margin;
      std::unordered_map<std::uint64_t, unsigned int> counts;
      std::vector<Index<dim>> blocks;
    };
  } // namespace

  template <int dim>
  OccupiedBlocks<dim>
  occupied_blocks(const std::vector<Body<dim>> &bodies,
                  const Lattice<dim> &lattice,
                  const bool with_force_margin)
  {
    BlockCount<dim> count(with_force_margin);
    for (const Body<dim> &body : bodies)
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        count.add(lattice.base_node(body.particles.position(p)), body.magnetic.is_magnetic());
    return count.sorted();
  }

  template <int dim>
  std::vector<Index<dim>>
  approached_blocks(const std::vector<Body<dim>> &bodies,
                    const Lattice<dim> &lattice,
                    const double time,
                    const bool with_force_margin)
  {
    BlockCount<dim> count(with_force_margin);
    for (const Body<dim> &body : bodies)
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          const Vector<dim> way = time * body.particles.vector(ParticleProperty::velocity, p);
          const int n_parts =
            std::max(1, static_cast<int>(std::ceil(norm(way) / (block_edge * lattice.spacing))));
          for (int part = 1; part <= n_parts; ++part)
            count.add(lattice.base_node(body.particles.position(p) +
                                        (static_cast<double>(part) / n_parts) * way),
                      body.magnetic.is_magnetic());
        }
    return count.sorted().blocks;
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

#define INSTANTIATE(dim)                                                             \
  template std::vector<Index<dim>> approached_blocks<dim>(                           \
    const std::vector<Body<dim>> &, const Lattice<dim> &, const double, const bool); \
  template OccupiedBlocks<dim> occupied_blocks(                                      \
    const std::vector<Body<dim>> &, const Lattice<dim> &, const bool);               \
  template void sort_into_blocks(const BlockSet<dim> &, const Lattice<dim> &, Body<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
