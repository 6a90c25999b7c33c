#pragma once

#include <magmpm/particles/transfer_runs.h>

/** The affine motion of the particles of a batch, from the sums of G2P and to those of P2G. */
namespace magmpm
{
  /**
   * The momentum of particles, number @p p of the batch on, as a linear function for P2G: its value
   * and how much it grows over dx in each direction.
   */
  template <int dim>
  inline void
  store_linear(const StencilBatch<dim> &stencils,
               const SimdDouble &mass,
               const Vector<dim, SimdDouble> &momentum,
               const Matrix<dim, SimdDouble> &slope,
               const int p,
               LinearBatch<dim> &batch)
  {
    constexpr int stride      = LinearBatch<dim>::stride;
    SimdDouble first[n_lanes] = {};
    for (int c = 0; c < dim; ++c)
      first[c] = momentum[c];
    for (int d = 0; d < dim; ++d)
      {
        const SimdDouble offset  = SimdDouble::load(&stencils.offsets[d][p]);
        SimdDouble step[n_lanes] = {};
        for (int c = 0; c < dim; ++c)
          {
            step[c] = slope(c, d);
            first[c] -= offset * step[c];
          }
        store_transposed(step, batch.numbers[p][1 + d], stride);
      }
    first[3] = mass;
    store_transposed(first, batch.numbers[p][0], stride);
  }

  /** What G2P found for particles, number @p p of the batch on: a vector and a matrix. */
  template <int dim>
  struct VectorAndMatrix
  {
    Vector<dim, SimdDouble> vector;
    Matrix<dim, SimdDouble> matrix;

    VectorAndMatrix(const LinearBatch<dim> &batch, const int p)
    {
      constexpr int stride      = LinearBatch<dim>::stride;
      SimdDouble lanes[n_lanes] = {};
      load_transposed(batch.numbers[p][0], stride, lanes);
      for (int c = 0; c < dim; ++c)
        vector[c] = lanes[c];
      for (int d = 0; d < dim; ++d)
        {
          load_transposed(batch.numbers[p][1 + d], stride, lanes);
          for (int c = 0; c < dim; ++c)
            matrix(c, d) = lanes[c];
        }
    }
  };

  /** Velocity and affine velocity of particles, number @p p of the batch on, from sums of G2P. */
  template <int dim>
  inline VectorAndMatrix<dim>
  affine_motion(const StencilBatch<dim> &stencils,
                const LinearBatch<dim> &batch,
                const double spacing,
                const int p)
  {
    VectorAndMatrix<dim> motion(batch, p);
    for (int d = 0; d < dim; ++d)
      {
        const SimdDouble offset = SimdDouble::load(&stencils.offsets[d][p]);
        for (int c = 0; c < dim; ++c)
          motion.matrix(c, d) = (4. / spacing) * (motion.matrix(c, d) - offset * motion.vector[c]);
      }
    return motion;
  }
} // namespace magmpm
