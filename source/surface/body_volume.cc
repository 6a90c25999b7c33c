#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/bspline.h>
#include <magmpm/parallel/exchange.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/parallel/together.h>
#include <magmpm/particles/particle_quantities.h>
#include <magmpm/surface/body_volume.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace magmpm
{
  namespace
  {
    /** A box around the nodes of all particles and one more. */
    template <int dim>
    NodeBox<dim>
    box_around(const Body<dim> &body, const Lattice<dim> &lattice, const MPI_Comm communicator)
    {
      // Lower corners, and upper ones with the sign changed, so that one minimum does for both.
      std::vector<int> corners(2 * dim, std::numeric_limits<int>::max());
      for (std::size_t p = 0; p < body.particles.size(); ++p)
        {
          const Index<dim> base = lattice.base_node(body.particles.position(p));
          for (int d = 0; d < dim; ++d)
            {
              corners[d]       = std::min(corners[d], base[d] - 1);
              corners[dim + d] = std::min(corners[dim + d], -(base[d] + stencil_width));
            }
        }
      corners = parallel::min(corners, communicator);
      NodeBox<dim> box;
      if (corners[0] == std::numeric_limits<int>::max())
        return box;
      for (int d = 0; d < dim; ++d)
        {
          box.first[d] = corners[d];
          box.count[d] = -corners[dim + d] - corners[d] + 1;
        }
      return box;
    }

    /** Nodes of the box with the same last coordinate. */
    template <int dim>
    std::size_t
    nodes_of_layer(const NodeBox<dim> &box)
    {
      std::size_t n = 1;
      for (int d = 0; d < dim - 1; ++d)
        n *= box.count[d];
      return n;
    }
  } // namespace

  template <int dim>
  BodyVolume<dim>::BodyVolume(const Body<dim> &body,
                              const Lattice<dim> &lattice,
                              const MPI_Comm communicator)
    : communicator(communicator)
    , all_nodes(box_around(body, lattice, communicator))
  {
    const double cell_volume = std::pow(lattice.spacing, dim);
    Index<dim> block;
    BlockValues *here = nullptr; // those of the block, which changes seldom
    for (std::size_t p = 0; p < body.particles.size(); ++p)
      {
        const double part = particle_volume_ratio(body, p) *
                            body.particles.component(ParticleProperty::volume, 0)[p] / cell_volume;
        for_stencil(
          lattice, body.particles.position(p), [&](const Index<dim> &node, const double weight) {
            if (here == nullptr || block_of<dim>(node) != block)
              {
                block = block_of<dim>(node);
                here  = &values_of(block);
              }
            (*here)[number_in_block<dim>(node)] += weight * part;
          });
      }
  }

  template <int dim>
  typename BodyVolume<dim>::BlockValues &
  BodyVolume<dim>::values_of(const Index<dim> &block)
  {
    const auto [slot, is_new] = slots.try_emplace(block_key<dim>(block), blocks.size());
    if (is_new)
      {
        blocks.push_back(block);
        values.emplace_back();
      }
    return values[slot->second];
  }

  template <int dim>
  std::vector<double>
  BodyVolume<dim>::packed_blocks(const int first_layer, const int end_layer) const
  {
    std::vector<double> packed;
    for (std::size_t b = 0; b < blocks.size(); ++b)
      if (blocks[b][dim - 1] >= first_layer && blocks[b][dim - 1] < end_layer)
        {
          packed.insert(packed.end(), blocks[b].begin(), blocks[b].end());
          packed.insert(packed.end(), values[b].begin(), values[b].end());
        }
    return packed;
  }

  template <int dim>
  void
  BodyVolume<dim>::add(const std::vector<double> &packed, NodeBox<dim> &slab)
  {
    constexpr int n_numbers = dim + nodes_per_block<dim>;
    for (std::size_t begin = 0; begin < packed.size(); begin += n_numbers)
      for (int n = 0; n < nodes_per_block<dim>; ++n)
        {
          std::size_t place = 0;
          bool is_inside    = true;
          for (int d = dim - 1; d >= 0; --d)
            {
              const int in_block = n / power(block_edge, d) % block_edge;
              const int i        = block_edge * static_cast<int>(packed[begin + d]) + in_block -
                            slab.first[d];
              is_inside = is_inside && i >= 0 && i < slab.count[d];
              place     = place * slab.count[d] + i;
            }
          if (is_inside) // others are empty
            slab.values[place] += packed[begin + dim + n];
        }
  }

  template <int dim>
  void
  BodyVolume<dim>::for_each_slab(const std::function<void(const NodeBox<dim> &)> &use,
                                 const std::size_t n_nodes) const
  {
    if (all_nodes.count[0] == 0)
      return;
    constexpr int last        = dim - 1;
    const std::size_t n_layer = nodes_of_layer(all_nodes);
    const int end             = all_nodes.first[last] + all_nodes.count[last];
    const int block_layers =
      static_cast<int>(std::clamp<std::size_t>(n_nodes / (block_edge * n_layer), 1, 1 << 20));

    NodeBox<dim> slab = all_nodes;
    std::vector<double> layer; // the last one of the slab before
    for (int begin = all_nodes.first[last]; begin < end;)
      {
        const int block = begin >> 2, end_block = block + block_layers;
        const int end_of_slab = std::min(end, block_edge * end_block);
        const auto parts      = parallel::exchange<double>({{0, packed_blocks(block, end_block)}},
                                                      communicator);
        parallel::on_first_rank(communicator, [&]() {
          const int overlap = layer.empty() ? 0 : 1;
          slab.first[last]  = begin - overlap;
          slab.count[last]  = end_of_slab - begin + overlap;
          slab.values       = layer;
          slab.values.resize(n_layer * slab.count[last], 0.);
          for (const auto &[rank, packed] : parts)
            add(packed, slab);
          use(slab);
          layer.assign(slab.values.end() - n_layer, slab.values.end());
        });
        begin = end_of_slab;
      }
  }

  template class BodyVolume<2>;
  template class BodyVolume<3>;
} // namespace magmpm
