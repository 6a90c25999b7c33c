#pragma once

#include <deal.II/lac/full_matrix.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/operators.h>

#include <magmpm/elliptic/cell_coefficient.h>
#include <magmpm/elliptic/elliptic_space.h>

#include <functional>

namespace magmpm
{
  /**
   * The Jacobian of an elliptic problem, without a matrix:
   *   a(u, v) = sum_C [c_C int grad v . grad u  +  sum_o w_o grad v . A_o grad u  +  v^T R_C u],
   * with c_C and A_o of the CellCoefficient of a cell and the element matrices R_C of the cells at the
   * open boundary (OpenBoundary). Coefficients are stored only for batches of cells that a medium fills,
   * matrices for those at the boundary; elsewhere c = 1 and A = 0. The first integral is exact. In double
   * on the active cells (CG) and in float on the levels of multigrid; for any number of SIMD lanes.
   */
  template <int dim, typename Number>
  class EllipticOperator
    : public dealii::MatrixFreeOperators::
        Base<dim, dealii::LinearAlgebra::distributed::Vector<Number>, CellLanes<Number>>
  {
  public:
    using VectorType = dealii::LinearAlgebra::distributed::Vector<Number>;
    using Lanes      = CellLanes<Number>;
    using Evaluation = dealii::FEEvaluation<dim, potential_degree, n_points_1d, 1, Number, Lanes>;
    using OctantEvaluation =
      dealii::FEEvaluation<dim, potential_degree, n_octants_1d, 1, Number, Lanes>;

    static constexpr unsigned int n_cell_dofs = Evaluation::static_dofs_per_cell;

    /** That of a cell (batch, lane), or a null pointer where no medium is. */
    using Coefficient =
      std::function<const CellCoefficient<dim> *(const unsigned int, const unsigned int)>;

    /** The element matrix of a cell (batch, lane), lexicographic, or a null pointer. */
    using CellMatrix =
      std::function<const dealii::FullMatrix<double> *(const unsigned int, const unsigned int)>;

    /** In place of initialize() for the operator of one level of multigrid. */
    void
    initialize_level(const std::shared_ptr<const CellBatches<dim, Number>> &cells,
                     const dealii::MGConstrainedDoFs &constraints,
                     const unsigned int level);

    void
    set_coefficient(const Coefficient &coefficient);

    void
    set_boundary_matrices(const CellMatrix &matrices);

    /** The inverse of the diagonal, for get_matrix_diagonal_inverse(). */
    void
    compute_diagonal() override;

    void
    clear() override;

    /**
     * The parts of the operator of a level that couple the edge of its refined region with the inside,
     * for dealii::MatrixFreeOperators::MGInterfaceOperator. Loop over the cells at that edge only.
     */
    void
    vmult_interface_down(VectorType &dst, const VectorType &src) const;

    void
    vmult_interface_up(VectorType &dst, const VectorType &src) const;

    /**
     * The element matrices at the open boundary times the values of a batch of cells: R_K u, zero where
     * there are none.
     *
     * @return u^T R_K u.
     */
    Lanes
    boundary_product(const unsigned int batch, const Lanes *values, Lanes *product) const;

  private:
    using Base = dealii::MatrixFreeOperators::Base<dim, VectorType, Lanes>;

    std::vector<bool> is_at_edge;   ///< of the refined region, by batch
    mutable bool edge_only = false; ///< whether apply_add() leaves the other batches out

    std::vector<unsigned int> media; ///< number in coefficients, by batch; invalid_entry: none
    std::vector<unsigned int> first_matrix; ///< in matrices, by batch; invalid_entry: none

    /** A CellCoefficient of each cell of a batch. */
    struct BatchCoefficient
    {
      Lanes whole = Number(1.);
      std::array<dealii::SymmetricTensor<2, dim, Lanes>, n_octants<dim>> octants;
    };

    dealii::AlignedVector<BatchCoefficient> coefficients;
    dealii::AlignedVector<Lanes> matrices;

    /** @param octants  a place to work. */
    void
    apply_to_cell(Evaluation &u, OctantEvaluation &octants) const;

    /** The diagonal of the element matrices of the present batch, by sum factorization. */
    void
    cell_diagonal(const Evaluation &u, OctantEvaluation &octants, Lanes *diagonal) const;

    void
    apply_add(VectorType &dst, const VectorType &src) const override;
  };
} // namespace magmpm
