#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/sparsity_tools.h>

#include <magmpm/elliptic/jacobian_assembler.h>
#include <magmpm/lattice/cell_stencil.h>

namespace magmpm
{
  template <int dim>
  JacobianAssembler<dim>::JacobianAssembler(const EllipticSpace<dim> &space)
    : space(space)
    , n_dofs(space.fe.n_dofs_per_cell())
    , quadrature(dealii::QGauss<dim>(n_points_1d))
    , lexicographic(dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(potential_degree))
    , gradients(quadrature.size() * n_dofs)
    , vacuum(n_dofs, n_dofs)
  {
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      for (unsigned int i = 0; i < n_dofs; ++i)
        gradients[q * n_dofs + i] = space.fe.shape_grad(i, quadrature.point(q));
    const std::vector<dealii::SymmetricTensor<2, dim>> identity(
      quadrature.size(), dealii::unit_symmetric_tensor<dim>());
    integrate(identity.data(), 1., vacuum);
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
    const dealii::SymmetricTensor<2, dim> *coefficient =
      jacobian.coefficient(space.lattice_cell_of_active_cell[cell->active_cell_index()]);
    if (coefficient != nullptr)
      integrate(coefficient, scaling, matrix);
    else
      matrix.equ(scaling, vacuum);

    dealii::FullMatrix<double> boundary_matrix;
    if (jacobian.boundary.element_matrix(cell, boundary_matrix))
      for (unsigned int i = 0; i < n_dofs; ++i)
        for (unsigned int j = 0; j < n_dofs; ++j)
          matrix(lexicographic[i], lexicographic[j]) += boundary_matrix(i, j);
  }

  template <int dim>
  void
  JacobianAssembler<dim>::integrate(const dealii::SymmetricTensor<2, dim> *coefficient,
                                    const double scaling,
                                    dealii::FullMatrix<double> &matrix) const
  {
    matrix = 0.;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      for (unsigned int i = 0; i < n_dofs; ++i)
        {
          const dealii::Tensor<1, dim> flux = scaling * quadrature.weight(q) *
                                              (coefficient[q] * gradients[q * n_dofs + i]);
          for (unsigned int j = 0; j <= i; ++j)
            matrix(i, j) += flux * gradients[q * n_dofs + j];
        }
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j < i; ++j)
        matrix(j, i) = matrix(i, j);
  }

  template class JacobianAssembler<2>;
  template class JacobianAssembler<3>;
} // namespace magmpm
