#pragma once

#include <magmpm/lattice/block_set.h>
#include <magmpm/lattice/node_quantity.h>

#include <algorithm>
#include <vector>

namespace magmpm
{
  /**
   * Numbers on every node of the active blocks: by slot, then by node (x fastest), then by lane. What
   * they are is known to NodeField; this much is enough to exchange, mirror and filter them.
   */
  template <int dim>
  class NodeNumbers
  {
  public:
    const NodeLayout &
    layout() const
    {
      return the_layout;
    }

    /** Makes room for @p n_blocks blocks and sets all values to zero. */
    void
    reinit(const int n_blocks)
    {
      values.assign(static_cast<std::size_t>(n_blocks) * numbers_per_block(), 0.);
    }

    void
    set_zero()
    {
      std::fill(values.begin(), values.end(), 0.);
    }

    int
    n_blocks() const
    {
      return static_cast<int>(values.size() / numbers_per_block());
    }

    int
    numbers_per_block() const
    {
      return nodes_per_block<dim> * the_layout.n_lanes;
    }

    /** The first number of the block in @p slot. */
    double *
    block(const int slot)
    {
      return values.data() + static_cast<std::size_t>(slot) * numbers_per_block();
    }

    const double *
    block(const int slot) const
    {
      return values.data() + static_cast<std::size_t>(slot) * numbers_per_block();
    }

    /** The lanes of node @p node (0 .. 4^dim - 1, x fastest) in @p slot. */
    double *
    node(const int slot, const int node)
    {
      return block(slot) + node * the_layout.n_lanes;
    }

    const double *
    node(const int slot, const int node) const
    {
      return block(slot) + node * the_layout.n_lanes;
    }

  protected:
    explicit NodeNumbers(const NodeLayout &layout)
      : the_layout(layout)
    {
    }

    std::vector<double> values;

  private:
    NodeLayout the_layout;
  };

  /**
   * The quantities of a list on every node of the active blocks, read and written by their names:
   * `field.get(NodeMotion::mass, slot, node)`.
   *
   * @tparam Quantities  NodeMotion is what nodes carry in every step.
   */
  template <int dim, typename Quantities = NodeMotion>
  class NodeField : public NodeNumbers<dim>
  {
  public:
    /** Numbers on a node, and in a block. */
    static constexpr int width      = node_layout<dim, Quantities>.n_lanes;
    static constexpr int block_size = nodes_per_block<dim> * width;

    NodeField()
      : NodeNumbers<dim>(node_layout<dim, Quantities>)
    {
    }

    explicit NodeField(const int n_blocks)
      : NodeField()
    {
      this->reinit(n_blocks);
    }

    /** As of NodeNumbers, with strides that the compiler knows. */
    double *
    block(const int slot)
    {
      return this->values.data() + static_cast<std::size_t>(slot) * block_size;
    }

    const double *
    block(const int slot) const
    {
      return this->values.data() + static_cast<std::size_t>(slot) * block_size;
    }

    double *
    node(const int slot, const int node)
    {
      return block(slot) + node * width;
    }

    const double *
    node(const int slot, const int node) const
    {
      return block(slot) + node * width;
    }

    double
    get(const NodeScalar<Quantities> quantity, const int slot, const int node) const
    {
      return this->node(slot, node)[quantity.lane];
    }

    Vector<dim>
    get(const NodeVector<Quantities> quantity, const int slot, const int node) const
    {
      Vector<dim> vector;
      std::copy_n(this->node(slot, node) + quantity.lane, dim, vector.values);
      return vector;
    }

    void
    set(const NodeScalar<Quantities> quantity, const int slot, const int node, const double value)
    {
      this->node(slot, node)[quantity.lane] = value;
    }

    void
    set(const NodeVector<Quantities> quantity,
        const int slot,
        const int node,
        const Vector<dim> &vector)
    {
      std::copy_n(vector.values, dim, this->node(slot, node) + quantity.lane);
    }

    template <typename Quantity, typename Value>
    void
    add(const Quantity quantity, const int slot, const int node, const Value &value)
    {
      set(quantity, slot, node, get(quantity, slot, node) + value);
    }
  };

  /** The node number @p number of @p block as an integer vector of the lattice. */
  template <int dim>
  inline Index<dim>
  node_of_block(const Index<dim> &block, int number)
  {
    Index<dim> node;
    for (int d = 0; d < dim; ++d, number /= block_edge)
      node[d] = block_edge * block[d] + number % block_edge;
    return node;
  }
} // namespace magmpm
