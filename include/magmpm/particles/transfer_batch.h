#pragma once

#include <magmpm/base/simd.h>
#include <magmpm/lattice/arena.h>
#include <magmpm/lattice/node_row.h>

namespace magmpm
{
  /**
   * Particles that a kernel takes together: what is done for a particle per lane (laws, weights) and
   * what is done for a node per lane (sums over the stencil) take turns, with their results in
   * arrays of this length, which the first-level cache holds beside an arena.
   */
  inline constexpr int batch_size = 64;

  /** Rows of three nodes along x in a stencil: row j + 3k is j up in y, k up in z. */
  template <int dim>
  inline constexpr int n_stencil_rows = power(stencil_width, dim - 1);

  /** Distance in an arena from a stencil's first row to row @p r [doubles]. */
  template <int dim>
  constexpr int
  row_offset(const int r)
  {
    const int in_plane = (r % stencil_width) * Arena<dim>::stride(1);
    return dim == 2 ? in_plane : in_plane + (r / stencil_width) * Arena<dim>::stride(dim - 1);
  }

  /**
   * The stencils of a batch, the 3^dim nodes around each particle, in an arena. The weight of a node
   * is that of its place in the row times that of the row.
   */
  template <int dim>
  struct StencilBatch
  {
    alignas(64) int first[batch_size]; ///< place of the first node in the arena [doubles]
    alignas(64) double weights[stencil_width][batch_size];
    alignas(64) double row_weights[n_stencil_rows<dim>][batch_size];
    alignas(64) double offsets[dim][batch_size]; ///< of the particle from the first node [dx]
  };

  /** How the weights of a batch grow with the place of the particle, in units of 1/dx. */
  template <int dim>
  struct StencilSlopes
  {
    alignas(64) double along_row[stencil_width][batch_size]; ///< of StencilBatch::weights

    /** Of StencilBatch::row_weights, along the other directions. */
    alignas(64) double across[dim - 1][n_stencil_rows<dim>][batch_size];
  };

  /**
   * What goes to or comes from the nodes around each particle of a batch, in the lanes of a node. To
   * the nodes goes a linear function: its value on the first node, and how much it grows from a node
   * to the next along each direction. From them come the weighted sum, and the sums weighted with
   * the number of the node along each direction (0, 1, 2) besides.
   */
  template <int dim>
  struct LinearBatch
  {
    static constexpr int stride = (1 + dim) * n_lanes;

    alignas(64) double numbers[batch_size][1 + dim][n_lanes];

    /**
     * Fills the lanes beyond particle @p n - 1 with its numbers, as PartialLanes do: what is left there
     * would count as extremes.
     */
    void
    repeat_last(const int n)
    {
      for (int p = n; p % SimdDouble::n_lanes != 0; ++p)
        std::memcpy(numbers[p], numbers[n - 1], sizeof(numbers[p]));
    }
  };

  /** Places particles on the lattice of the arena of a block. */
  template <int dim>
  class StencilsOfBlock
  {
  public:
    StencilsOfBlock(const Lattice<dim> &lattice, const Index<dim> &block)
      : origin(lattice.node_position(Arena<dim>::first_node(block)))
      , inverse_spacing(1. / lattice.spacing)
    {
    }

    /**
     * Where in the arena the first node of each particle is [doubles].
     *
     * @param offsets  on return of the particles from it [dx].
     */
    SimdDouble::Integer
    first_nodes(const Vector<dim, SimdDouble> &position, Vector<dim, SimdDouble> &offsets) const
    {
      SimdDouble::Integer first = {};
      for (int d = 0; d < dim; ++d)
        {
          const SimdDouble x = (position[d] - origin[d]) * inverse_spacing;
          const auto node    = (x - 0.5).truncated();
          offsets[d]         = x - SimdDouble::from_integer(node);
          first += node * Arena<dim>::stride(d);
        }
      return first;
    }

    /** Fills the stencils from the one numbered @p p on, one for each lane of @p position. */
    void
    place(const Vector<dim, SimdDouble> &position, const int p, StencilBatch<dim> &stencils) const
    {
      Vector<dim, SimdDouble> offsets;
      const SimdDouble::Integer first = first_nodes(position, offsets);
      SimdDouble weights[dim][stencil_width];
      for (int d = 0; d < dim; ++d)
        {
          quadratic_bspline(offsets[d], weights[d]);
          offsets[d].store(&stencils.offsets[d][p]);
        }
      std::memcpy(&stencils.first[p], &first, sizeof(first));
      for (int i = 0; i < stencil_width; ++i)
        weights[0][i].store(&stencils.weights[i][p]);
      for (int r = 0; r < n_stencil_rows<dim>; ++r)
        {
          SimdDouble weight = weights[1][r % stencil_width];
          if constexpr (dim == 3)
            weight *= weights[2][r / stencil_width];
          weight.store(&stencils.row_weights[r][p]);
        }
    }

    /** The slopes of the stencils from the one numbered @p p on, where place() put them. */
    static void
    find_slopes(const StencilBatch<dim> &stencils, const int p, StencilSlopes<dim> &slopes)
    {
      SimdDouble weights[dim][stencil_width], derivatives[dim][stencil_width];
      for (int d = 0; d < dim; ++d)
        {
          const SimdDouble offset = SimdDouble::load(&stencils.offsets[d][p]);
          quadratic_bspline(offset, weights[d]);
          quadratic_bspline_derivative(offset, derivatives[d]);
        }
      for (int i = 0; i < stencil_width; ++i)
        derivatives[0][i].store(&slopes.along_row[i][p]);
      for (int r = 0; r < n_stencil_rows<dim>; ++r)
        {
          const int j = r % stencil_width, k = r / stencil_width;
          if constexpr (dim == 2)
            derivatives[1][j].store(&slopes.across[0][r][p]);
          else
            {
              (derivatives[1][j] * weights[2][k]).store(&slopes.across[0][r][p]);
              (weights[1][j] * derivatives[2][k]).store(&slopes.across[1][r][p]);
            }
        }
    }

  private:
    Vector<dim> origin;
    double inverse_spacing;
  };

  /** @p lanes times the weight of each node's place in a row of particle @p p. */
  template <int dim>
  inline NodeRow
  weighted_row(const StencilBatch<dim> &stencils, const NodeLanes &lanes, const int p)
  {
    NodeRow row;
    for (int i = 0; i < stencil_width; ++i)
      row.nodes[i] = stencils.weights[i][p] * lanes;
    return row;
  }

  /** The nodes of a row added up, with the weights of their places. */
  template <int dim>
  inline NodeLanes
  weighted_sum(const StencilBatch<dim> &stencils, const NodeRow &row, const int p)
  {
    NodeLanes sum = stencils.weights[0][p] * row.nodes[0];
    for (int i = 1; i < stencil_width; ++i)
      sum += stencils.weights[i][p] * row.nodes[i];
    return sum;
  }

  /** Adds N_i times a linear function, both of particle @p p, to the rows of its stencil. */
  template <int dim>
  inline void
  add_linear(const StencilBatch<dim> &stencils,
             const LinearBatch<dim> &batch,
             const int p,
             NodeRow (&rows)[n_stencil_rows<dim>])
  {
    const auto lanes = [&](const int i) { return NodeLanes::load(batch.numbers[p][i]); };
    NodeRow first;
    NodeLanes value = lanes(0);
    for (int i = 0; i < stencil_width; ++i, value += lanes(1))
      first.nodes[i] = stencils.weights[i][p] * value;
    const NodeRow step_y = weighted_row(stencils, lanes(2), p);
    const NodeRow step_z = weighted_row(stencils, lanes(dim), p); // 3D only
    for (int k = 0; k < (dim == 3 ? stencil_width : 1); ++k)
      {
        NodeRow row = first;
        for (int j = 0; j < stencil_width; ++j)
          {
            const int r = j + stencil_width * k;
            rows[r].add(stencils.row_weights[r][p], row);
            row += step_y;
          }
        first += step_z;
      }
  }

  /** Sums over the stencil of particle @p p; see LinearBatch. */
  template <int dim>
  inline void
  sum_linear(const StencilBatch<dim> &stencils,
             const NodeRow (&rows)[n_stencil_rows<dim>],
             const int p,
             LinearBatch<dim> &batch)
  {
    NodeRow by_y[stencil_width], by_z[stencil_width];
    for (int r = 0; r < n_stencil_rows<dim>; ++r)
      {
        by_y[r % stencil_width].add(stencils.row_weights[r][p], rows[r]);
        by_z[r / stencil_width].add(stencils.row_weights[r][p], rows[r]);
      }
    // 0 times the first, 1 times the second, 2 times the third.
    const auto moment = [](const auto &first, const auto &second) {
      auto sum = first;
      sum += second;
      sum += second;
      return sum;
    };
    NodeRow sum = by_y[0];
    sum += by_y[1];
    sum += by_y[2];
    const NodeLanes second = stencils.weights[1][p] * sum.nodes[1];
    const NodeLanes third  = stencils.weights[2][p] * sum.nodes[2];
    (stencils.weights[0][p] * sum.nodes[0] + second + third).store(batch.numbers[p][0]);
    moment(second, third).store(batch.numbers[p][1]);
    weighted_sum(stencils, moment(by_y[1], by_y[2]), p).store(batch.numbers[p][2]);
    if constexpr (dim == 3)
      weighted_sum(stencils, moment(by_z[1], by_z[2]), p).store(batch.numbers[p][3]);
  }

  /** Adds N_i @p value of particle @p p to the rows of its stencil. */
  template <int dim>
  inline void
  add_constant(const StencilBatch<dim> &stencils,
               const NodeLanes &value,
               const int p,
               NodeRow (&rows)[n_stencil_rows<dim>])
  {
    const NodeRow row = weighted_row(stencils, value, p);
    for (int r = 0; r < n_stencil_rows<dim>; ++r)
      rows[r].add(stencils.row_weights[r][p], row);
  }

  /** sum_i N_i q_i for particle @p p. */
  template <int dim>
  inline NodeLanes
  sum_constant(const StencilBatch<dim> &stencils,
               const NodeRow (&rows)[n_stencil_rows<dim>],
               const int p)
  {
    NodeRow sum;
    for (int r = 0; r < n_stencil_rows<dim>; ++r)
      sum.add(stencils.row_weights[r][p], rows[r]);
    return weighted_sum(stencils, sum, p);
  }

  /**
   * Adds what @p n particles give their nodes to an arena: add(p, rows) adds what particle p gives.
   * Rows stay in registers over particles that share their nodes, as sorted ones do.
   */
  template <int dim, typename Add>
  inline void
  scatter_batch(const StencilBatch<dim> &stencils, const int n, double *arena, const Add &add)
  {
    for (int p = 0; p < n;)
      {
        const int first = stencils.first[p];
        NodeRow rows[n_stencil_rows<dim>];
        do
          add(p++, rows);
        while (p < n && stencils.first[p] == first);
        for (int r = 0; r < n_stencil_rows<dim>; ++r)
          rows[r].add_to(arena + first + row_offset<dim>(r));
      }
  }

  /** Calls take(p, rows) for @p n particles with the nodes around each. */
  template <int dim, typename Take>
  inline void
  gather_batch(const StencilBatch<dim> &stencils,
               const int n,
               const double *arena,
               const Take &take)
  {
    for (int p = 0; p < n;)
      {
        const int first = stencils.first[p];
        NodeRow rows[n_stencil_rows<dim>];
        for (int r = 0; r < n_stencil_rows<dim>; ++r)
          rows[r] = NodeRow::load(arena + first + row_offset<dim>(r));
        do
          take(p++, rows);
        while (p < n && stencils.first[p] == first);
      }
  }
} // namespace magmpm
