#pragma once

#include <magmpm/base/simd.h>
#include <magmpm/particles/particle_set.h>

namespace magmpm
{
  // Where to load from and store to: at one particle (its number), at as many in a row as SimdDouble
  // has lanes, or at fewer of these.

  struct FullLanes
  {
    std::size_t first;
  };

  struct PartialLanes
  {
    std::size_t first;
    int n;
  };

  inline double
  load(const double *array, const std::size_t p)
  {
    return array[p];
  }

  inline SimdDouble
  load(const double *array, const FullLanes place)
  {
    return SimdDouble::load(array + place.first);
  }

  inline SimdDouble
  load(const double *array, const PartialLanes place)
  {
    return SimdDouble::load(array + place.first, place.n);
  }

  inline void
  store(const double number, double *array, const std::size_t p)
  {
    array[p] = number;
  }

  inline void
  store(const SimdDouble &numbers, double *array, const FullLanes place)
  {
    numbers.store(array + place.first);
  }

  inline void
  store(const SimdDouble &numbers, double *array, const PartialLanes place)
  {
    numbers.store(array + place.first, place.n);
  }

  /** double for one particle, SimdDouble for several. */
  template <typename Place>
  using NumberAt = decltype(load(static_cast<const double *>(nullptr), Place()));

  /** A vector at @p place from the arrays of its components. */
  template <int dim, typename Number, typename Place>
  inline Vector<dim, NumberAt<Place>>
  load_vector(Number *const (&components)[dim], const Place place)
  {
    Vector<dim, NumberAt<Place>> vector;
    for (int d = 0; d < dim; ++d)
      vector[d] = load(components[d], place);
    return vector;
  }

  template <int dim, typename Place>
  inline void
  store_vector(const Vector<dim, NumberAt<Place>> &vector,
               double *const (&components)[dim],
               const Place place)
  {
    for (int d = 0; d < dim; ++d)
      store(vector[d], components[d], place);
  }

  /** A matrix at @p place from the arrays of its components, by rows. */
  template <int dim, typename Number, typename Place>
  inline Matrix<dim, NumberAt<Place>>
  load_matrix(Number *const (&components)[dim * dim], const Place place)
  {
    Matrix<dim, NumberAt<Place>> matrix;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        matrix(i, j) = load(components[dim * i + j], place);
    return matrix;
  }

  template <int dim, typename Place>
  inline void
  store_matrix(const Matrix<dim, NumberAt<Place>> &matrix,
               double *const (&components)[dim * dim],
               const Place place)
  {
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        store(matrix(i, j), components[dim * i + j], place);
  }

  /** The deformation at @p place as its law stores it: F or J. */
  template <int dim, typename Law, typename Number, typename Place>
  inline typename Law::State
  load_state(const ParticleArrays<dim, Number> &particles, const Place place)
  {
    if constexpr (Law::stores_deformation_gradient)
      return load_matrix<dim>(particles.deformation, place);
    else
      return load(particles.deformation[0], place);
  }

  template <int dim, typename Law, typename Place>
  inline void
  store_state(const typename Law::State &state,
              const ParticleArrays<dim> &particles,
              const Place place)
  {
    if constexpr (Law::stores_deformation_gradient)
      store_matrix<dim>(state, particles.deformation, place);
    else
      store(state, particles.deformation[0], place);
  }
} // namespace magmpm
