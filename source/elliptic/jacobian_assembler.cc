#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/sparsity_tools.h>

#include <magmpm/elliptic/jacobian_assembler.h>
#include <magmpm/lattice/cell_quadrature.h>

namespace magmpm
{
  template <int dim>
  JacobianAssembler<dim>::JacobianAssembler(const EllipticSpace<dim> &space)
    : space(space)
    , n_dofs(space.fe.n_dofs_per_cell())
    , octants(dealii::QGauss<dim>(n_octants_1d))
    , lexicographic(dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(potential_degree))
    , gradients(octants.size() * n_dofs)
    , vacuum(n_dofs, n_dofs)
  {
    for (unsigned int q = 0; q < octants.size(); ++q)
      for (unsigned int i = 0; i < n_dofs; ++i)
        gradients[q * n_dofs + i] = space.fe.shape_grad(i, octants.point(q));
    const dealii::QGauss<dim> quadrature(n_points_1d);
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < n_dofs; ++j)
          vacuum(i, j) += quadrature.weight(q) * space.fe.shape_grad(i, quadrature.point(q)) *
                          space.fe.shape_grad(j, quadrature.point(q));
  }

  template <int dim>
  dealii::DynamicSparsityPattern
  JacobianAssembler<dim>::sparsity_pattern() const
  {
    dealii::DynamicSparsityPattern pattern(space.relevant_dofs);
    dealii::DoFTools::make_sparsity_pattern(space.dof_handler, pattern, space.constraints, false);
    dealii::SparsityTools::distribute_sparsity_pattern(pattern,
                                                       space.dof_handler.locally_owned_dofs(),
                                                       space.mesh.communicator(),
                                                       space.relevant_dofs);
    return pattern;
  }

  template <int dim>
  void
  JacobianAssembler<dim>::compute(const JacobianData<dim> &jacobian,
                                  const Cell &cell,
                                  dealii::FullMatrix<double> &matrix) const
  {
    const double scaling = std::pow(cell->extent_in_direction(0), dim - 2);
    const CellCoefficient<dim> *coefficient =
      jacobian.coefficient(space.lattice_cell_of_active_cell[cell->active_cell_index()]);
    matrix.equ(coefficient == nullptr ? scaling : coefficient->whole * scaling, vacuum);
    if (coefficient != nullptr)
      add_octants(*coefficient, scaling, matrix);

    dealii::FullMatrix<double> boundary_matrix;
    if (jacobian.boundary.element_matrix(cell, boundary_matrix))
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < n_dofs; ++j)
          matrix(lexicographic[i], lexicographic[j]) += boundary_matrix(i, j);
  }

  template <int dim>
  void
  JacobianAssembler<dim>::add_octants(const CellCoefficient<dim> &coefficient,
                                      const double scaling,
                                      dealii::FullMatrix<double> &matrix) const
  {
    for (unsigned int q = 0; q < octants.size(); ++q)
      for (unsigned int i = 0; i < n_dofs; ++i)
        {
          const dealii::Tensor<1, dim> flux = scaling * octants.weight(q) *
                                              (coefficient.octants[q] * gradients[q * n_dofs + i]);
          for (unsigned int j = 0; j < n_dofs; ++j)
            matrix(i, j) += flux * gradients[q * n_dofs + j];
        }
  }

  template class JacobianAssembler<2>;
  template class JacobianAssembler<3>;
} // namespace magmpm
