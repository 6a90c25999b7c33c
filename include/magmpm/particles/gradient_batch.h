#pragma once

#include <magmpm/particles/transfer_batch.h>

namespace magmpm
{
  /**
   * What goes to the nodes around each particle of a batch by the gradients of their B-splines: for each
   * direction a vector in the lanes of a node.
   */
  template <int dim>
  struct GradientBatch
  {
    static constexpr int stride = dim * n_lanes;

    alignas(64) double numbers[batch_size][dim][n_lanes];
  };

  /**
   * Adds N_i times a linear function, and sum_d dN_i/dx_d times the vectors of @p gradients, both of
   * particle @p p, to the rows of its stencil; see add_linear().
   */
  template <int dim>
  inline void
  add_linear_and_gradient(const StencilBatch<dim> &stencils,
                          const StencilSlopes<dim> &slopes,
                          const LinearBatch<dim> &batch,
                          const GradientBatch<dim> &gradients,
                          const int p,
                          NodeRow (&rows)[n_stencil_rows<dim>])
  {
    const auto linear   = [&](const int i) { return NodeLanes::load(batch.numbers[p][i]); };
    const auto gradient = [&](const int d) { return NodeLanes::load(gradients.numbers[p][d]); };
    // What differs along a row but not from row to row, beside the row's weight.
    const NodeLanes step = linear(1), along = gradient(0);
    NodeRow in_row;
    NodeLanes value = {};
    for (int i = 0; i < stencil_width; ++i, value += step)
      in_row.nodes[i] = stencils.weights[i][p] * value + slopes.along_row[i][p] * along;

    NodeLanes first = linear(0);
    for (int k = 0; k < (dim == 3 ? stencil_width : 1); ++k)
      {
        NodeLanes start = first;
        for (int j = 0; j < stencil_width; ++j)
          {
            const int r            = j + stencil_width * k;
            const NodeLanes weight = stencils.row_weights[r][p];
            NodeLanes of_row       = weight * start + slopes.across[0][r][p] * gradient(1);
            if constexpr (dim == 3)
              of_row += slopes.across[1][r][p] * gradient(2);
            for (int i = 0; i < stencil_width; ++i)
              rows[r].nodes[i] += stencils.weights[i][p] * of_row + weight * in_row.nodes[i];
            start += linear(2);
          }
        first += linear(dim); // 3D only
      }
  }

  /**
   * Value and gradient of the lattice's field at particle @p p: sum_i N_i q_i, in the place of the value
   * of @p batch, and sum_i q_i dN_i/dx_d, in those of the steps [1/dx].
   */
  template <int dim>
  inline void
  sum_gradient(const StencilBatch<dim> &stencils,
               const StencilSlopes<dim> &slopes,
               const NodeRow (&rows)[n_stencil_rows<dim>],
               const int p,
               LinearBatch<dim> &batch)
  {
    NodeLanes value = {}, along = {}, across[dim - 1] = {};
    for (int r = 0; r < n_stencil_rows<dim>; ++r)
      {
        const NodeLanes of_row = weighted_sum(stencils, rows[r], p);
        NodeLanes slope        = slopes.along_row[0][p] * rows[r].nodes[0];
        for (int i = 1; i < stencil_width; ++i)
          slope += slopes.along_row[i][p] * rows[r].nodes[i];
        value += stencils.row_weights[r][p] * of_row;
        along += stencils.row_weights[r][p] * slope;
        for (int d = 0; d < dim - 1; ++d)
          across[d] += slopes.across[d][r][p] * of_row;
      }
    value.store(batch.numbers[p][0]);
    along.store(batch.numbers[p][1]);
    for (int d = 0; d < dim - 1; ++d)
      across[d].store(batch.numbers[p][2 + d]);
  }
} // namespace magmpm
