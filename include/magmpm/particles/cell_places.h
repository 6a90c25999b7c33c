#pragma once

#include <magmpm/lattice/lattice.h>
#include <magmpm/particles/body_parameters.h>

#include <vector>

namespace magmpm
{
  /** Where particles lie along the edge of a lattice cell. */
  enum class PlaceRule
  {
    gauss,  ///< at the Gauss points, with their weights: moments up to the order 2 n - 1 are exact
    centres ///< in the middle of n equal parts, with equal weights
  };

  /** A place for a particle in the cell from -1/2 to 1/2. */
  template <int dim>
  struct CellPlace
  {
    int number; ///< among all n^dim, x fastest
    Vector<dim> position;
    double weight; ///< those of all places in a cell sum to 1
  };

  /**
   * The places of n along each edge that hold particles; face-centred n must be 2 or more.
   *
   * @param parity  face-centred: of the places along all axes together before the cell's first one; even
   *                and odd cells are alike if n is even. Then centroid and moments of inertia of the places
   *                are those of all; in 2D the product of inertia is not.
   */
  template <int dim>
  std::vector<CellPlace<dim>>
  cell_places(const PlaceRule rule, const int n, const Arrangement arrangement, const int parity);
} // namespace magmpm
