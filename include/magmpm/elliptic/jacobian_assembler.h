#pragma once

#include <deal.II/base/quadrature.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <magmpm/elliptic/elliptic_solver.h>

#include <vector>

namespace magmpm
{
  /**
   * The Jacobian as a matrix, for algebraic multigrid: element matrices with hanging nodes condensed.
   * Their own rows hold a positive number on the diagonal and nothing else, so that the matrix is
   * symmetric positive definite as a whole.
   *
   * Cells are cubes: gradients on the unit cube serve all of them, scaled by the edge.
   */
  template <int dim>
  class JacobianAssembler
  {
  public:
    explicit JacobianAssembler(const EllipticSpace<dim> &space);

    /** Of the matrix, of all ranks. */
    dealii::types::global_dof_index
    n_rows() const
    {
      return space.dof_handler.n_dofs();
    }

    /** Where the matrix has entries: all of this rank's rows, and none of others. Collective. */
    dealii::DynamicSparsityPattern
    sparsity_pattern() const;

    /**
     * Adds this rank's cells to @p matrix, in any rows: whoever owns it sends these to their owners.
     *
     * @param matrix  of deal.II, or what AffineConstraints::distribute_local_to_global() takes for one.
     */
    template <typename Matrix>
    void
    add_to(const JacobianData<dim> &jacobian, Matrix &matrix) const;

  private:
    using Cell = typename dealii::DoFHandler<dim>::active_cell_iterator;

    const EllipticSpace<dim> &space;
    const unsigned int n_dofs; ///< of a cell
    const dealii::Quadrature<dim> octants;
    const std::vector<unsigned int> lexicographic;
    std::vector<dealii::Tensor<1, dim>> gradients; ///< [octant][degree of freedom]
    dealii::FullMatrix<double> vacuum;             ///< int grad v . grad u on the unit cube

    /** The element matrix of a cell, in deal.II's numbering. */
    void
    compute(const JacobianData<dim> &jacobian,
            const Cell &cell,
            dealii::FullMatrix<double> &matrix) const;

    /** Adds sum_o w_o grad v . A_o grad u. */
    void
    add_octants(const CellCoefficient<dim> &coefficient,
                const double scaling,
                dealii::FullMatrix<double> &matrix) const;
  };

  template <int dim>
  template <typename Matrix>
  void
  JacobianAssembler<dim>::add_to(const JacobianData<dim> &jacobian, Matrix &matrix) const
  {
    dealii::FullMatrix<double> element(n_dofs, n_dofs);
    std::vector<dealii::types::global_dof_index> dofs(n_dofs);
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          compute(jacobian, cell, element);
          cell->get_dof_indices(dofs);
          space.constraints.distribute_local_to_global(element, dofs, matrix);
        }
  }
} // namespace magmpm
