#pragma once

#include <magmpm/particles/particle_set.h>

namespace magmpm
{
  /** A vector of particle @p p from the arrays of its components. */
  template <int dim, typename Number>
  inline Vector<dim>
  load_vector(Number *const (&components)[dim], const std::size_t p)
  {
    Vector<dim> vector;
    for (int d = 0; d < dim; ++d)
      vector[d] = components[d][p];
    return vector;
  }

  template <int dim>
  inline void
  store_vector(const Vector<dim> &vector, double *const (&components)[dim], const std::size_t p)
  {
    for (int d = 0; d < dim; ++d)
      components[d][p] = vector[d];
  }

  /** A matrix of particle @p p from the arrays of its components, by rows. */
  template <int dim, typename Number>
  inline Matrix<dim>
  load_matrix(Number *const (&components)[dim * dim], const std::size_t p)
  {
    Matrix<dim> matrix;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        matrix(i, j) = components[dim * i + j][p];
    return matrix;
  }

  template <int dim>
  inline void
  store_matrix(const Matrix<dim> &matrix,
               double *const (&components)[dim * dim],
               const std::size_t p)
  {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        components[dim * i + j][p] = matrix(i, j);
  }

  /** The deformation of particle @p p as its law stores it: F or J. */
  template <int dim, typename Law, typename Number>
  inline typename Law::State
  load_state(const ParticleArrays<dim, Number> &particles, const std::size_t p)
  {
    if constexpr (Law::stores_deformation_gradient)
      return load_matrix<dim>(particles.deformation, p);
    else
      return particles.deformation[0][p];
  }

  template <int dim, typename Law>
  inline void
  store_state(const typename Law::State &state,
              const ParticleArrays<dim> &particles,
              const std::size_t p)
  {
    if constexpr (Law::stores_deformation_gradient)
      store_matrix<dim>(state, particles.deformation, p);
    else
      particles.deformation[0][p] = state;
  }
} // namespace magmpm
