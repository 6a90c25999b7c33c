#pragma once

#include <deal.II/base/symmetric_tensor.h>

#include <magmpm/elliptic/elliptic_medium.h>
#include <magmpm/elliptic/elliptic_operator.h>

#include <array>
#include <vector>

namespace magmpm
{
  /**
   * Residual and functional of an elliptic problem with the flux q(grad phi) of a medium, the
   * derivative of the energy density w:
   *   F(phi; v) = int grad v . q(grad phi) + int c phi v,
   *   Pi(phi)   = int w(grad phi) + int c phi^2/2,          F = dPi/dphi,
   * and the tangent K = dq/d(grad phi) at the same quadrature points, so that the Jacobian is exact.
   */
  template <int dim>
  class EllipticResidual
  {
  public:
    /**
     * All of it at @p potential, in one loop over the cells.
     *
     * @param jacobian  for the element matrices of the open boundary.
     */
    void
    evaluate(const EllipticSpace<dim> &space,
             const EllipticMedium<dim> &medium,
             const EllipticOperator<dim, double> &jacobian,
             const PotentialVector &potential,
             PotentialVector &residual);

    /** Pi of all ranks at the potential last evaluated. Collective. */
    double
    functional() const;

    /** K at the n_points<dim> points of a lattice cell, or a null pointer where it is 1. */
    const dealii::SymmetricTensor<2, dim> *
    coefficient(const unsigned int lattice_cell) const
    {
      const unsigned int first = lattice_cell == invalid_entry ? invalid_entry
                                                               : first_tensor[lattice_cell];
      return first == invalid_entry ? nullptr : &tensors[first];
    }

  private:
    std::vector<unsigned int> first_tensor; ///< in tensors, by lattice cell, or invalid_entry
    std::vector<dealii::SymmetricTensor<2, dim>> tensors;
    double local_functional = 0.;
    MPI_Comm communicator   = MPI_COMM_SELF;

    using Lanes  = typename EllipticOperator<dim, double>::Lanes;
    using Fluxes = std::array<dealii::Tensor<1, dim, Lanes>, n_points<dim>>;

    /** Makes room for the tensors of the cells that the medium fills. */
    void
    number_tensors(const EllipticMedium<dim> &medium, const std::size_t n_lattice_cells);

    /**
     * Makes q of grad phi at the points of one lane, keeps the tangents, and returns what the medium adds
     * to the functional.
     */
    double
    apply_medium(const EllipticMedium<dim> &medium,
                 const unsigned int lattice_cell,
                 const unsigned int lane,
                 Fluxes &fluxes);
  };
} // namespace magmpm
