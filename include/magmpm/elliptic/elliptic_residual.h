#pragma once

#include <magmpm/elliptic/elliptic_medium.h>
#include <magmpm/elliptic/elliptic_operator.h>

#include <array>
#include <vector>

namespace magmpm
{
  /**
   * Residual and functional of an elliptic problem with what a medium adds to the flux, p(grad phi), the
   * derivative of the energy density w:
   *   F(phi; v) = int (1 + s) grad v . grad phi + sum_o w_o grad v . [p(grad phi) - s grad phi] + int c phi v,
   *   Pi(phi)   = int (1 + s) |grad phi|^2/2 + sum_o w_o [w(grad phi) - s |grad phi|^2/2] + int c phi^2/2,
   * F = dPi/dphi, with the sums over the octants of cells and the stabilization s of the medium, and the
   * tangent, so that the Jacobian is exact.
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
             const MediumResponse response,
             const EllipticOperator<dim, double> &jacobian,
             const PotentialVector &potential,
             PotentialVector &residual);

    /** Pi of all ranks at the potential last evaluated. Collective. */
    double
    functional() const;

    /** K of a lattice cell, or a null pointer where no medium is. */
    const CellCoefficient<dim> *
    coefficient(const unsigned int lattice_cell) const
    {
      const unsigned int number = lattice_cell == invalid_entry ? invalid_entry
                                                                : filled[lattice_cell];
      return number == invalid_entry ? nullptr : &coefficients[number];
    }

  private:
    std::vector<unsigned int> filled; ///< number in coefficients, by lattice cell, or invalid_entry
    std::vector<CellCoefficient<dim>> coefficients;
    double local_functional = 0.;
    MPI_Comm communicator   = MPI_COMM_SELF;

    using Operator         = EllipticOperator<dim, double>;
    using OctantEvaluation = typename Operator::OctantEvaluation;

    /** Makes room for the tangents of the cells that the medium fills. */
    void
    number_cells(const EllipticMedium<dim> &medium, const std::size_t n_lattice_cells);

    /**
     * Tests p, less the part of the stabilization that is negative, in the cells of a batch that the medium
     * fills, keeps the tangents, and adds to the functional.
     *
     * @param values  of the potential in the batch.
     * @param phi     its evaluation in octants; with tested values on return.
     * @param whole   1 + s of each cell on return.
     * @return false if it fills none of them.
     */
    bool
    apply_medium(const EllipticSpace<dim> &space,
                 const EllipticMedium<dim> &medium,
                 const MediumResponse response,
                 const unsigned int batch,
                 const typename Operator::Evaluation &values,
                 OctantEvaluation &phi,
                 typename Operator::Lanes &whole);

    /** The same of one cell: p, less that part, and the tangent there. */
    void
    respond(const EllipticMedium<dim> &medium,
            const MediumResponse response,
            const unsigned int lattice_cell,
            OctantVectors<dim> &flux,
            const double weight);
  };
} // namespace magmpm
