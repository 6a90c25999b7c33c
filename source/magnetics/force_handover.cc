#include <magmpm/lattice/node_window.h>
#include <magmpm/magnetics/force_handover.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    constexpr int n_layers = 2;
    constexpr int outside  = n_layers + 1; ///< the number of what is further out

    /**
     * Distance from the nodes with mass, 0 .. n_layers, or outside: of owned nodes and of those next to
     * them. A layer of the latter depends on masses at most 1 + n_layers nodes from owned ones, and
     * ghosts are four nodes wide: no rank has to ask.
     */
    template <int dim>
    class Layers
    {
    public:
      Layers(const BlockSet<dim> &blocks, const NodeField<dim, SingleScalar> &mass)
      {
        static_assert(1 + n_layers <= block_edge, "ghosts would not reach that far");
        numbers.reinit(blocks.size());
        for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
          const bool has_mass = mass.get(SingleScalar::value, slot, node) > 0.;
          numbers.set(SingleScalar::value, slot, node, has_mass ? 0 : outside);
        });
        for (int layer = 1; layer <= n_layers; ++layer)
          for_nodes_and_ghosts(blocks, [&](const int slot, const int node) {
            if (is_in(outside, slot, node))
              for_nodes_around(blocks, slot, node, [&](const int other_slot, const int other) {
                if (is_in(layer - 1, other_slot, other))
                  numbers.set(SingleScalar::value, slot, node, layer);
              });
          });
      }

      bool
      is_in(const int layer, const int slot, const int node) const
      {
        return numbers.get(SingleScalar::value, slot, node) == layer;
      }

    private:
      NodeField<dim, SingleScalar> numbers;
    };
  } // namespace

  template <int dim>
  Vector<dim>
  hand_force_inward(const BlockPartition<dim> &partition,
                    const NodeField<dim, SingleScalar> &mass,
                    NodeField<dim, SingleVector> &force)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    const Layers<dim> layers(blocks, mass);

    constexpr auto vector = SingleVector::value;
    Vector<dim> dropped;
    for_nodes(blocks, [&](const int slot, const int node) {
      if (layers.is_in(outside, slot, node))
        {
          dropped += force.get(vector, slot, node);
          force.set(vector, slot, node, {});
        }
    });

    for (int layer = n_layers; layer >= 1; --layer)
      {
        for_nodes(blocks, [&](const int slot, const int node) {
          if (!layers.is_in(layer, slot, node))
            return;
          int n_receivers = 0;
          for_nodes_around(blocks, slot, node, [&](const int other_slot, const int other) {
            n_receivers += layers.is_in(layer - 1, other_slot, other);
          });
          const Vector<dim> part = (1. / n_receivers) * force.get(vector, slot, node);
          for_nodes_around(blocks, slot, node, [&](const int other_slot, const int other) {
            if (layers.is_in(layer - 1, other_slot, other))
              force.add(vector, other_slot, other, part);
          });
          force.set(vector, slot, node, {});
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
