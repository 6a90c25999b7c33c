#pragma once

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/matrix_free/fe_evaluation.h>
#include <deal.II/matrix_free/operators.h>

#include <magmpm/elliptic/elliptic_space.h>
#include <magmpm/lattice/cell_stencil.h>

#include <functional>

namespace magmpm
{
  /**
   * The Jacobian of an elliptic problem, without a matrix:
   *   a(u, v) = int grad v . K grad u  +  sum_C v^T R_C u,
   * K symmetric positive definite at every quadrature point, R_C the element matrices of the cells at the
   * open boundary (OpenBoundary). K is stored only for batches of cells that a medium fills, R_C for
   * those at the boundary; elsewhere K = I costs nothing. In double on the active cells (CG) and in float on
   * the levels of multigrid; for any number of SIMD lanes.
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

    static constexpr unsigned int n_cell_dofs = Evaluation::static_dofs_per_cell;

    /** The n_points<dim> tensors of a cell (batch, lane), or a null pointer where K = I. */
    using CellCoefficient =
      std::function<const dealii::SymmetricTensor<2, dim> *(const unsigned int,
                                                            const unsigned int)>;

    /** The element matrix of a cell (batch, lane), lexicographic, or a null pointer. */
    using CellMatrix =
      std::function<const dealii::FullMatrix<double> *(const unsigned int, const unsigned int)>;

    /** In place of initialize() for the operator of one level of multigrid. */
    void
    initialize_level(const std::shared_ptr<const CellBatches<dim, Number>> &cells,
                     const dealii::MGConstrainedDoFs &constraints,
                     const unsigned int level);

    void
    set_coefficient(const CellCoefficient &coefficient);

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

    std::vector<unsigned int> first_tensor; ///< in tensors, by batch; invalid_entry: K = I
    std::vector<unsigned int> first_matrix; ///< in matrices, by batch; invalid_entry: none

    dealii::AlignedVector<dealii::SymmetricTensor<2, dim, Lanes>> tensors;
    dealii::AlignedVector<Lanes> matrices;

    void
    apply_to_cell(Evaluation &u) const;

    /** The diagonal of the element matrices of the present batch, by sum factorization. */
    void
    cell_diagonal(const Evaluation &u, Lanes *diagonal) const;

    void
    apply_add(VectorType &dst, const VectorType &src) const override;
  };
} // namespace magmpm
