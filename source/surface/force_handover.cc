#include <magmpm/lattice/lattice_node.h>
#include <magmpm/lattice/node_window.h>
#include <magmpm/surface/force_handover.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr int n_layers = 2;

    constexpr auto force_vector = SingleVector::value;

    /**
     * Distance of nodes from those with mass. It is found where somebody asks, since
     * few nodes without mass bear a force. Of nodes next to owned ones it depends on masses at most
     * 1 + n_layers nodes from owned ones, and ghosts are four nodes wide: no rank has to ask.
     */
    template <int dim>
    class Layers
    {
    public:
      static_assert(1 + n_layers <= block_edge, "ghosts would not reach that far");

      Layers(const BlockSet<dim> &blocks, const NodeField<dim, SingleScalar> &mass)
        : blocks(blocks)
        , mass(mass)
      {
      }

      bool
      has_mass(const int slot, const int node) const
      {
        return mass.get(SingleScalar::value, slot, node) > 0.;
      }

      bool
      is_within(const int layer, const int slot, const int node) const
      {
        if (layer == 0)
          return has_mass(slot, node);
        return any_node_around(blocks, slot, node, [&](const int other_slot, const int other) {
          return is_within(layer - 1, other_slot, other);
        });
      }

      bool
      is_in(const int layer, const int slot, const int node) const
      {
        return is_within(layer, slot, node) && (layer == 0 || !is_within(layer - 1, slot, node));
      }

    private:
      const BlockSet<dim> &blocks;
      const NodeField<dim, SingleScalar> &mass;
    };

    /** Gives the force on a node of a layer to its neighbours in the next inner one, in equal parts. */
    template <int dim>
    void
    give_inward(const BlockSet<dim> &blocks,
                const Layers<dim> &layers,
                const int layer,
                const int slot,
                const int node,
                NodeField<dim, SingleVector> &force)
    {
      std::array<LatticeNode, n_neighbours<dim>> receivers;
      int n_receivers = 0;
      for_nodes_around(blocks, slot, node, [&](const int other_slot, const int other) {
        if (layers.is_in(layer - 1, other_slot, other))
          receivers[n_receivers++] = {other_slot, other};
      });
      const Vector<dim> part = (1. / n_receivers) * force.get(force_vector, slot, node);
      for (int i = 0; i < n_receivers; ++i)
        force.add(force_vector, receivers[i].slot, receivers[i].number, part);
      force.set(force_vector, slot, node, {});
    }
  } // namespace

  template <int dim>
  Vector<dim>
  hand_force_inward(const BlockPartition<dim> &partition,
                    const NodeField<dim, SingleScalar> &mass,
                    NodeField<dim, SingleVector> &force)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    const Layers<dim> layers(blocks, mass);
    Vector<dim> dropped;
    for (int layer = n_layers; layer >= 1; --layer)
      {
        for_nodes(blocks, [&](const int slot, const int node) {
          const Vector<dim> f = force.get(force_vector, slot, node);
          if (dot(f, f) == 0. || layers.has_mass(slot, node))
            return;
          if (layers.is_within(layer - 1, slot, node))
            return; // until that layer's turn
          if (layers.is_within(layer, slot, node))
            return give_inward(blocks, layers, layer, slot, node, force);
          dropped += f;
          force.set(force_vector, slot, node, {});
        });
        partition.add_ghosts_to_owners(force);
      }
    return dropped;
  }

#define MAGMPM_INSTANTIATE(dim)                                                \
  template Vector<dim> hand_force_inward(const BlockPartition<dim> &,          \
                                         const NodeField<dim, SingleScalar> &, \
                                         NodeField<dim, SingleVector> &);

  MAGMPM_INSTANTIATE(2)
  MAGMPM_INSTANTIATE(3)
} // namespace magmpm
