#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <magmpm/lattice/cell_quadrature.h>

#include <array>

namespace magmpm
{
  /**
   * The tangent K of a cell that a medium fills: a number in all of it, integrated exactly, plus a tensor
   * in each octant. Vacuum is 1 and nothing.
   */
  template <int dim>
  struct CellCoefficient
  {
    double whole = 1.;
    std::array<dealii::SymmetricTensor<2, dim>, n_octants<dim>> octants;

    /** For messages between ranks. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &whole;
      for (auto &octant : octants)
        archive &octant;
    }
  };
} // namespace magmpm
