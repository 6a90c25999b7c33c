#include <magmpm/lattice/node_window.h>
#include <magmpm/mesh/node_filters.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    /** A block and one node around it. */
    template <int dim>
    using Window = NodeWindow<dim, 1, 1>;

    /** One lane of its nodes. */
    template <int dim>
    using Values = std::array<double, Window<dim>::n_nodes>;

    /** Nodes that are not active count as zero. */
    template <int dim>
    void
    gather(const NodeNumbers<dim> &field,
           const BlockSet<dim> &blocks,
           const int slot,
           const int lane,
           Values<dim> &values)
    {
      const auto &neighbours = blocks.neighbours(slot);
      for (int i = 0; i < Window<dim>::n_nodes; ++i)
        {
          const NodePlace &place = Window<dim>::place(i);
          const int other        = neighbours[place.neighbour];
          values[i] = (other == invalid_slot ? 0. : field.node(other, place.node)[lane]);
        }
    }

    /** 1 on active nodes, 0 elsewhere. */
    template <int dim>
    void
    gather_activity(const BlockSet<dim> &blocks, const int slot, Values<dim> &values)
    {
      const auto &neighbours = blocks.neighbours(slot);
      for (int i = 0; i < Window<dim>::n_nodes; ++i)
        values[i] = (neighbours[Window<dim>::place(i).neighbour] == invalid_slot ? 0. : 1.);
    }

    /**
     * out = combine(below, here, above) along one axis. Values at the ends of the array are not
     * computed; the block's own never depend on them.
     */
    template <int dim, typename Combine>
    void
    along_axis(const Values<dim> &in, const int axis, const Combine &combine, Values<dim> &out)
    {
      const int stride = Window<dim>::stride(axis);
      const int n      = Window<dim>::n_nodes;
      for (int i = stride; i < n - stride; ++i)
        out[i] = combine(in[i - stride], in[i], in[i + stride]);
    }

    /** The same along all axes, one after the other. */
    template <int dim, typename Combine>
    void
    along_all_axes(Values<dim> &values, const Combine &combine)
    {
      Values<dim> other = values;
      for (int axis = 0; axis < dim; ++axis)
        {
          along_axis<dim>(values, axis, combine, other);
          values = other;
        }
    }

    /**
     * Calls filter(slot, values of a lane) for the owned blocks and puts the values in place, then
     * images and ghosts.
     */
    template <int dim, typename Filter>
    void
    apply_filter(const BlockPartition<dim> &partition,
                 NodeNumbers<dim> &field,
                 const Filter &filter)
    {
      const BlockSet<dim> &blocks = partition.blocks();
      const NodeNumbers<dim> unfiltered(field);
      Values<dim> values;
      for (int slot = 0; slot < blocks.n_owned(); ++slot)
        for (int lane = 0; lane < field.layout().n_lanes; ++lane)
          {
            gather(unfiltered, blocks, slot, lane, values);
            filter(slot, values);
            for (int node = 0; node < nodes_per_block<dim>; ++node)
              field.node(slot, node)[lane] = values[Window<dim>::of_block(node)];
          }
      partition.update_ghosts(field, Parity());
    }
  } // namespace

  template <int dim>
  void
  remove_smear(const BlockPartition<dim> &partition, NodeNumbers<dim> &field)
  {
    apply_filter(partition, field, [](const int, Values<dim> &values) {
      const Values<dim> smeared = values;
      Values<dim> difference    = {};
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
  maximize(const BlockPartition<dim> &partition, NodeNumbers<dim> &field)
  {
    apply_filter(partition, field, [](const int, Values<dim> &values) {
      along_all_axes<dim>(values, [](const double below, const double here, const double above) {
        return std::max(here, std::max(below, above));
      });
    });
  }

  template <int dim>
  void
  smooth(const BlockPartition<dim> &partition, NodeNumbers<dim> &field)
  {
    const auto weight = [](const double below, const double here, const double above) {
      return 0.25 * (below + above) + 0.5 * here;
    };
    const BlockSet<dim> &blocks = partition.blocks();
    apply_filter(partition, field, [&](const int slot, Values<dim> &values) {
      const auto &around = blocks.neighbours(slot);
      const bool is_edge = std::find(around.begin(), around.end(), invalid_slot) != around.end();
      Values<dim> unfiltered;
      if (is_edge)
        unfiltered = values;
      along_all_axes<dim>(values, weight);
      if (!is_edge)
        return;
      Values<dim> activity;
      gather_activity<dim>(blocks, slot, activity);
      along_all_axes<dim>(activity, weight);
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += (1. - activity[i]) * unfiltered[i];
    });
  }

#define MAGMPM_INSTANTIATE(dim)                                                \
  template void remove_smear(const BlockPartition<dim> &, NodeNumbers<dim> &); \
  template void maximize(const BlockPartition<dim> &, NodeNumbers<dim> &);     \
  template void smooth(const BlockPartition<dim> &, NodeNumbers<dim> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
