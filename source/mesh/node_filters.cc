#include <magmpm/mesh/node_filters.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** A block and one node around it: 6^dim nodes, the first at (-1, -1, ..) of the block. */
    template <int dim>
    class BlockAndRim
    {
    public:
      static constexpr int edge    = block_edge + 2;
      static constexpr int n_nodes = power(edge, dim);
      using Values                 = std::array<double, n_nodes * n_lanes>;

      BlockAndRim()
      {
        for (int i = 0; i < n_nodes; ++i)
          {
            places[i] = {0, 0};
            for (int d = 0, rest = i; d < dim; ++d, rest /= edge)
              {
                const int place = rest % edge + block_edge - 1; // from the block below
                places[i].neighbour += power(3, d) * (place / block_edge);
                places[i].node += power(block_edge, d) * (place % block_edge);
              }
          }
      }

      /** Nodes that are not active count as zero. */
      void
      gather(const NodeField<dim> &field,
             const BlockSet<dim> &blocks,
             const int slot,
             Values &values) const
      {
        const auto &neighbours = blocks.neighbours(slot);
        for (int i = 0; i < n_nodes; ++i)
          {
            const int other = neighbours[places[i].neighbour];
            if (other == invalid_slot)
              std::fill_n(&values[i * n_lanes], n_lanes, 0.);
            else
              std::copy_n(field.node(other, places[i].node), n_lanes, &values[i * n_lanes]);
          }
      }

      /** 1 on active nodes, 0 elsewhere, in all lanes. */
      void
      gather_activity(const BlockSet<dim> &blocks, const int slot, Values &values) const
      {
        const auto &neighbours = blocks.neighbours(slot);
        for (int i = 0; i < n_nodes; ++i)
          std::fill_n(&values[i * n_lanes],
                      n_lanes,
                      neighbours[places[i].neighbour] == invalid_slot ? 0. : 1.);
      }

      /** Copies the nodes of the block itself back. */
      void
      put(const Values &values, const int slot, NodeField<dim> &field) const
      {
        for (int node = 0; node < nodes_per_block<dim>; ++node)
          std::copy_n(&values[n_lanes * place(node)], n_lanes, field.node(slot, node));
      }

      /** Place of a node of the block among all. */
      static int
      place(const int node)
      {
        int result = 0;
        for (int d = 0, rest = node; d < dim; ++d, rest /= block_edge)
          result += power(edge, d) * (rest % block_edge + 1);
        return result;
      }

      /** Distance in doubles of neighbours along an axis. */
      static constexpr int
      stride(const int axis)
      {
        return n_lanes * power(edge, axis);
      }

    private:
      struct Place
      {
        int neighbour;
        int node;
      };

      std::array<Place, n_nodes> places;
    };

    /**
     * out = combine(below, here, above) along one axis. Values at the ends of the array are not
     * computed; the block's own never depend on them.
     */
    template <int dim, typename Combine>
    void
    along_axis(const typename BlockAndRim<dim>::Values &in,
               const int axis,
               const Combine &combine,
               typename BlockAndRim<dim>::Values &out)
    {
      const int stride = BlockAndRim<dim>::stride(axis);
      const int n      = static_cast<int>(in.size());
      for (int i = stride; i < n - stride; ++i)
        out[i] = combine(in[i - stride], in[i], in[i + stride]);
    }

    /** The same along all axes, one after the other. */
    template <int dim, typename Combine>
    void
    along_all_axes(typename BlockAndRim<dim>::Values &values, const Combine &combine)
    {
      typename BlockAndRim<dim>::Values other = values;
      for (int axis = 0; axis < dim; ++axis)
        {
          along_axis<dim>(values, axis, combine, other);
          values = other;
        }
    }

    /** Calls filter(slot, values) for the owned blocks, puts the values in place, updates ghosts. */
    template <int dim, typename Filter>
    void
    apply_filter(const BlockPartition<dim> &partition, NodeField<dim> &field, const Filter &filter)
    {
      const BlockSet<dim> &blocks = partition.blocks();
      static const BlockAndRim<dim> nodes;
      NodeField<dim> result;
      result.reinit(blocks.size());
      typename BlockAndRim<dim>::Values values;
      for (int slot = 0; slot < blocks.n_owned(); ++slot)
        {
          nodes.gather(field, blocks, slot, values);
          filter(nodes, slot, values);
          nodes.put(values, slot, result);
        }
      partition.update_ghosts(result);
      std::swap(field, result);
    }
  } // namespace

  template <int dim>
  void
  remove_smear(const BlockPartition<dim> &partition, NodeField<dim> &field)
  {
    using Values = typename BlockAndRim<dim>::Values;
    apply_filter(partition, field, [](const auto &, const int, Values &values) {
      const Values smeared = values;
      Values difference    = {};
      for (int axis = 0; axis < dim; ++axis)
        {
          along_axis<dim>(
            smeared,
            axis,
            [](const double below, const double here, const double above) {
              return 0.25 * (below + above - 2. * here);
            },
            difference);
          for (std::size_t i = 0; i < values.size(); ++i)
            values[i] -= difference[i];
        }
    });
  }

  template <int dim>
  void
  maximize(const BlockPartition<dim> &partition, NodeField<dim> &field)
  {
    using Values = typename BlockAndRim<dim>::Values;
    apply_filter(partition, field, [](const auto &, const int, Values &values) {
      along_all_axes<dim>(values, [](const double below, const double here, const double above) {
        return std::max(here, std::max(below, above));
      });
    });
  }

  template <int dim>
  void
  smooth(const BlockPartition<dim> &partition, NodeField<dim> &field)
  {
    using Values      = typename BlockAndRim<dim>::Values;
    const auto weight = [](const double below, const double here, const double above) {
      return 0.25 * (below + above) + 0.5 * here;
    };
    const BlockSet<dim> &blocks = partition.blocks();
    apply_filter(partition, field, [&](const auto &nodes, const int slot, Values &values) {
      const auto &around = blocks.neighbours(slot);
      const bool is_edge = std::find(around.begin(), around.end(), invalid_slot) != around.end();
      Values unfiltered;
      if (is_edge)
        unfiltered = values;
      along_all_axes<dim>(values, weight);
      if (!is_edge)
        return;
      Values activity;
      nodes.gather_activity(blocks, slot, activity);
      along_all_axes<dim>(activity, weight);
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += (1. - activity[i]) * unfiltered[i];
    });
  }

#define MAGMPM_INSTANTIATE(dim)                                              \
  template void remove_smear(const BlockPartition<dim> &, NodeField<dim> &); \
  template void maximize(const BlockPartition<dim> &, NodeField<dim> &);     \
  template void smooth(const BlockPartition<dim> &, NodeField<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
