#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <magmpm/magnetics/material_points.h>
#include <magmpm/elliptic/potential_operator.h>

#include <array>
#include <vector>

namespace magmpm
{
  /**
   * Residual and energy of the potential problem, h = -grad phi, H = H_ext + h:
   *   F(phi; v) = int grad v . (grad phi - M(H)) + int c phi v,
   *   Pi(phi)   = int [|h|^2/2 + psi(H)] + int c phi^2/2,          F = dPi/dphi,
   * and the tangent I + dM/dH at the same quadrature points, so that the Jacobian is exact. H_ext^2,
   * which reaches 1e12 near magnets, never enters.
   */
  template <int dim>
  class PotentialResidual
  {
  public:
    /**
     * All of it at @p potential, in one loop over the cells.
     *
     * @param jacobian  for the element matrices of the open boundary.
     */
    void
    evaluate(const PotentialSpace<dim> &space,
             const MaterialPoints<dim> &material,
             const PotentialOperator<dim, double> &jacobian,
             const PotentialVector &potential,
             PotentialVector &residual);

    /** Pi [A^2 m] of all ranks at the potential last evaluated. Collective. */
    double
    energy() const;

    /** The n_points<dim> tensors I + dM/dH of a lattice cell, or a null pointer without material. */
    const dealii::SymmetricTensor<2, dim> *
    permeability(const MaterialPoints<dim> &material, const unsigned int lattice_cell) const
    {
      const unsigned int first = lattice_cell == invalid_entry ? material.none
                                                               : material.first_point(lattice_cell);
      return first == material.none ? nullptr : &tensors[first];
    }

  private:
    std::vector<dealii::SymmetricTensor<2, dim>> tensors; ///< by point of MaterialPoints
    double local_energy   = 0.;
    MPI_Comm communicator = MPI_COMM_SELF;

    using Lanes  = typename PotentialOperator<dim, double>::Lanes;
    using Fluxes = std::array<dealii::Tensor<1, dim, Lanes>, n_points<dim>>;

    /**
     * Subtracts M from grad phi at the points of one lane, keeps the tangents, and returns the integral
     * of psi over the cell.
     */
    double
    subtract_magnetization(const MaterialPoints<dim> &material,
                           const unsigned int lattice_cell,
                           const unsigned int lane,
                           Fluxes &fluxes);
  };
} // namespace magmpm
