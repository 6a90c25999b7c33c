#pragma once

#include <magmpm/base/prefetch.h>
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

  /** The stencils of a batch, the 3^dim nodes around each particle, in an arena. */
  template <int dim>
  struct StencilBatch
  {
    alignas(64) int first[batch_size]; ///< place of the lowest node in the arena [doubles]

    /** N_i along each direction, and N_i (x_i - x_p)/dx. */
    alignas(64) double weights[dim][stencil_width][batch_size];
    alignas(64) double moments[dim][stencil_width][batch_size];
  };

  /**
   * What goes to or comes from the nodes around each particle of a batch, in the lanes of a node: the
   * value at the particle, and the slope or first moment along each direction, times or over dx.
   */
  template <int dim>
  struct LinearBatch
  {
    static constexpr int stride = (1 + dim) * n_lanes;

    alignas(64) double numbers[batch_size][1 + dim][n_lanes];
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

    /** Fills the stencils from the one numbered @p p on, one for each lane of @p position. */
    void
    place(const Vector<dim, SimdDouble> &position, const int p, StencilBatch<dim> &stencils) const
    {
      SimdDouble::Integer first = {};
      for (int d = 0; d < dim; ++d)
        {
          const SimdDouble x        = (position[d] - origin[d]) * inverse_spacing;
          const auto node           = (x - 0.5).truncated();
          const SimdDouble distance = x - SimdDouble::from_integer(node);
          first += node * Arena<dim>::stride(d);

          SimdDouble weights[stencil_width];
          quadratic_bspline(distance, weights);
          for (int i = 0; i < stencil_width; ++i)
            {
              weights[i].store(&stencils.weights[d][i][p]);
              (weights[i] * (i - distance)).store(&stencils.moments[d][i][p]);
            }
        }
      std::memcpy(&stencils.first[p], &first, sizeof(first));
    }

  private:
    Vector<dim> origin;
    double inverse_spacing;
  };

  /** The factors of the three nodes in a row along x, in all lanes, for particle @p p. */
  inline NodeRow
  row_factors(const double (&factors)[stencil_width][batch_size], const int p)
  {
    return {{factors[0][p], factors[1][p], factors[2][p]}};
  }

  template <int dim>
  inline constexpr int n_stencil_rows = power(stencil_width, dim - 1);

  /** Distance in an arena from a stencil's first row to row @p r. */
  template <int dim>
  constexpr int
  row_offset(const int r)
  {
    const int in_plane = (r % stencil_width) * Arena<dim>::stride(1);
    return dim == 2 ? in_plane : in_plane + (r / stencil_width) * Arena<dim>::stride(dim - 1);
  }

  /** Adds N_i (value + slope (x_i - x_p)) of particle @p p to the rows of its stencil. */
  template <int dim>
  inline void
  add_linear(const StencilBatch<dim> &stencils,
             const LinearBatch<dim> &batch,
             const int p,
             NodeRow (&rows)[n_stencil_rows<dim>])
  {
    const auto lanes     = [&](const int i) { return NodeLanes::load(batch.numbers[p][i]); };
    const NodeRow weight = row_factors(stencils.weights[0], p);
    NodeRow along_x      = weight * lanes(0);
    along_x.add(lanes(1), row_factors(stencils.moments[0], p));
    const NodeRow slope_y = weight * lanes(2);
    const auto add_plane  = [&](const NodeRow &value, const NodeRow &slope, const int first_row) {
      for (int j = 0; j < stencil_width; ++j)
        {
          rows[first_row + j].add(stencils.weights[1][j][p], value);
          rows[first_row + j].add(stencils.moments[1][j][p], slope);
        }
    };
    if constexpr (dim == 2)
      add_plane(along_x, slope_y, 0);
    else
      {
        const NodeRow slope_z = weight * lanes(3);
        for (int k = 0; k < stencil_width; ++k)
          {
            NodeRow value = along_x * stencils.weights[2][k][p];
            value.add(stencils.moments[2][k][p], slope_z);
            add_plane(value, slope_y * stencils.weights[2][k][p], k * stencil_width);
          }
      }
  }

  /** For particle @p p: sum_i N_i q_i, and sum_i N_i q_i (x_i - x_p)/dx along each direction. */
  template <int dim>
  inline void
  sum_linear(const StencilBatch<dim> &stencils,
             const NodeRow (&rows)[n_stencil_rows<dim>],
             const int p,
             LinearBatch<dim> &batch)
  {
    const auto sum_plane = [&](const auto &factors, const int first_row) {
      NodeRow sum = rows[first_row] * factors[0][p];
      for (int j = 1; j < stencil_width; ++j)
        sum.add(factors[j][p], rows[first_row + j]);
      return sum;
    };
    NodeRow sum, moment_y, moment_z;
    if constexpr (dim == 2)
      {
        sum      = sum_plane(stencils.weights[1], 0);
        moment_y = sum_plane(stencils.moments[1], 0);
      }
    else
      for (int k = 0; k < stencil_width; ++k)
        {
          const NodeRow plane = sum_plane(stencils.weights[1], k * stencil_width);
          sum.add(stencils.weights[2][k][p], plane);
          moment_z.add(stencils.moments[2][k][p], plane);
          moment_y.add(stencils.weights[2][k][p],
                       sum_plane(stencils.moments[1], k * stencil_width));
        }
    const NodeRow weight = row_factors(stencils.weights[0], p);
    const auto finish    = [&](const NodeRow &factors, const NodeRow &row, const int i) {
      (factors * row).sum().store(batch.numbers[p][i]);
    };
    finish(weight, sum, 0);
    finish(row_factors(stencils.moments[0], p), sum, 1);
    finish(weight, moment_y, 2);
    if constexpr (dim == 3)
      finish(weight, moment_z, 3);
  }

  /** The weight of row @p r of a stencil. */
  template <int dim>
  inline double
  row_weight(const StencilBatch<dim> &stencils, const int r, const int p)
  {
    double weight = stencils.weights[1][r % stencil_width][p];
    if constexpr (dim == 3)
      weight *= stencils.weights[2][r / stencil_width][p];
    return weight;
  }

  /** Adds N_i @p value of particle @p p to the rows of its stencil. */
  template <int dim>
  inline void
  add_constant(const StencilBatch<dim> &stencils,
               const NodeLanes &value,
               const int p,
               NodeRow (&rows)[n_stencil_rows<dim>])
  {
    const NodeRow row = row_factors(stencils.weights[0], p) * value;
    for (int r = 0; r < n_stencil_rows<dim>; ++r)
      rows[r].add(row_weight(stencils, r, p), row);
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
      sum.add(row_weight(stencils, r, p), rows[r]);
    return (row_factors(stencils.weights[0], p) * sum).sum();
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
