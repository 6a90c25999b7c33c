#include <magmpm/magnetics/force_handover.h>

#include <algorithm>
#include <array>

namespace magmpm
{
  namespace
  {
    constexpr int n_layers = 2;
    constexpr int outside  = n_layers + 1; ///< the number of what is further out

    /** Calls action(slot, node) for all nodes of owned blocks. */
    template <int dim, typename Action>
    void
    for_owned_nodes(const BlockSet<dim> &blocks, const Action &action)
    {
      for (int slot = 0; slot < blocks.n_owned(); ++slot)
        for (int node = 0; node < nodes_per_block<dim>; ++node)
          action(slot, node);
    }

    /** Where the 3^dim nodes around a node lie, for all nodes of a block. */
    template <int dim>
    class NeighbourNodes
    {
    public:
      struct Place
      {
        int neighbour; ///< of the block, see BlockSet::neighbours()
        int node;      ///< in that block
      };
      using Places = std::array<Place, n_neighbours<dim>>;

      static const Places &
      around(const int node)
      {
        static const NeighbourNodes table;
        return table.places[node];
      }

    private:
      std::array<Places, nodes_per_block<dim>> places;

      NeighbourNodes()
      {
        for (int node = 0; node < nodes_per_block<dim>; ++node)
          for (int n = 0; n < n_neighbours<dim>; ++n)
            {
              Place &place = places[node][n];
              place        = {0, 0};
              for (int d = 0, rest_node = node, rest = n; d < dim; ++d)
                {
                  const int along = rest_node % block_edge + rest % 3 - 1; // -1 .. 4
                  place.neighbour += power(3, d) * (along < 0 ? 0 : (along < block_edge ? 1 : 2));
                  place.node += power(block_edge, d) * ((along + block_edge) % block_edge);
                  rest_node /= block_edge;
                  rest /= 3;
                }
            }
      }
    };

    /** Calls action(slot, node) for the 3^dim nodes around a node (itself included) in active blocks. */
    template <int dim, typename Action>
    void
    for_neighbour_nodes(const BlockSet<dim> &blocks,
                        const int slot,
                        const int node,
                        const Action &action)
    {
      const auto &neighbours = blocks.neighbours(slot);
      for (const auto &place : NeighbourNodes<dim>::around(node))
        if (neighbours[place.neighbour] != invalid_slot)
          action(neighbours[place.neighbour], place.node);
    }

    /** Distance from the nodes with mass, 0 .. n_layers, or outside; on ghosts too. */
    template <int dim>
    class Layers
    {
    public:
      Layers(const BlockPartition<dim> &partition, const NodeField<dim> &mass)
      {
        const BlockSet<dim> &blocks = partition.blocks();
        numbers.reinit(blocks.size());
        for_owned_nodes(blocks, [&](const int slot, const int node) {
          const bool has_mass         = mass.node(slot, node)[n_lanes - 1] > 0.;
          numbers.node(slot, node)[0] = has_mass ? 0 : outside;
        });
        partition.update_ghosts(numbers);
        for (int layer = 1; layer <= n_layers; ++layer)
          {
            for_owned_nodes(blocks, [&](const int slot, const int node) {
              if (is_in(outside, slot, node))
                for_neighbour_nodes(blocks, slot, node, [&](const int other_slot, const int other) {
                  if (is_in(layer - 1, other_slot, other))
                    numbers.node(slot, node)[0] = layer;
                });
            });
            partition.update_ghosts(numbers);
          }
      }

      bool
      is_in(const int layer, const int slot, const int node) const
      {
        return numbers.node(slot, node)[0] == layer;
      }

    private:
      NodeField<dim> numbers; ///< in lane 0
    };
  } // namespace

  template <int dim>
  Vector<dim>
  hand_force_inward(const BlockPartition<dim> &partition,
                    const NodeField<dim> &mass,
                    NodeField<dim> &force)
  {
    const BlockSet<dim> &blocks = partition.blocks();
    const Layers<dim> layers(partition, mass);

    Vector<dim> dropped;
    for_owned_nodes(blocks, [&](const int slot, const int node) {
      if (layers.is_in(outside, slot, node))
        {
          for (int d = 0; d < dim; ++d)
            dropped[d] += force.node(slot, node)[d];
          std::fill_n(force.node(slot, node), dim, 0.);
        }
    });

    for (int layer = n_layers; layer >= 1; --layer)
      {
        for_owned_nodes(blocks, [&](const int slot, const int node) {
          if (!layers.is_in(layer, slot, node))
            return;
          int n_receivers = 0;
          for_neighbour_nodes(blocks, slot, node, [&](const int other_slot, const int other) {
            n_receivers += layers.is_in(layer - 1, other_slot, other);
          });
          double *given = force.node(slot, node);
          for_neighbour_nodes(blocks, slot, node, [&](const int other_slot, const int other) {
            if (layers.is_in(layer - 1, other_slot, other))
              for (int d = 0; d < dim; ++d)
                force.node(other_slot, other)[d] += given[d] / n_receivers;
          });
          std::fill_n(given, dim, 0.);
        });
        partition.add_ghosts_to_owners(force);
      }
    return dropped;
  }

  template Vector<2>
  hand_force_inward(const BlockPartition<2> &, const NodeField<2> &, NodeField<2> &);
  template Vector<3>
  hand_force_inward(const BlockPartition<3> &, const NodeField<3> &, NodeField<3> &);
} // namespace magmpm
