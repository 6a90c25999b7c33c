#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <magmpm/magnetics/cell_stencil.h>
#include <magmpm/magnetics/ml_preconditioner.h>

namespace magmpm
{
  namespace
  {
    /** Element matrices on cells that are all cubes: gradients on the unit cube, scaled by the edge. */
    template <int dim>
    class ElementMatrices
    {
    public:
      explicit ElementMatrices(const dealii::FE_Q<dim> &fe)
        : n_dofs(fe.n_dofs_per_cell())
        , quadrature(n_points_1d)
        , gradients(quadrature.size() * n_dofs)
        , vacuum(n_dofs, n_dofs)
        , lexicographic(
            dealii::FETools::lexicographic_to_hierarchic_numbering<dim>(potential_degree))
      {
        std::vector<dealii::SymmetricTensor<2, dim>> identity(quadrature.size(),
                                                              dealii::unit_symmetric_tensor<dim>());
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          for (unsigned int i = 0; i < n_dofs; ++i)
            gradients[q * n_dofs + i] = fe.shape_grad(i, quadrature.point(q));
        fill(identity.data(), 1., vacuum);
      }

      /** int grad v . K grad u on a cell; @p permeability null: K = I. */
      void
      compute(const dealii::SymmetricTensor<2, dim> *permeability,
              const double edge,
              dealii::FullMatrix<double> &matrix) const
      {
        if (permeability != nullptr)
          fill(permeability, std::pow(edge, dim - 2), matrix);
        else
          matrix.equ(std::pow(edge, dim - 2), vacuum);
      }

      /** Adds a matrix that is numbered lexicographically. */
      void
      add_lexicographic(const dealii::FullMatrix<double> &part,
                        dealii::FullMatrix<double> &matrix) const
      {
        for (unsigned int i = 0; i < n_dofs; ++i)
          for (unsigned int j = 0; j < n_dofs; ++j)
            matrix(lexicographic[i], lexicographic[j]) += part(i, j);
      }

      const unsigned int n_dofs;

    private:
      const dealii::QGauss<dim> quadrature;
      std::vector<dealii::Tensor<1, dim>> gradients;
      dealii::FullMatrix<double> vacuum;
      const std::vector<unsigned int> lexicographic;

      void
      fill(const dealii::SymmetricTensor<2, dim> *permeability,
           const double scaling,
           dealii::FullMatrix<double> &matrix) const
      {
        matrix = 0.;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          for (unsigned int i = 0; i < n_dofs; ++i)
            {
              const dealii::Tensor<1, dim> flux = scaling * quadrature.weight(q) *
                                                  (permeability[q] * gradients[q * n_dofs + i]);
              for (unsigned int j = 0; j <= i; ++j)
                matrix(i, j) += flux * gradients[q * n_dofs + j];
            }
        for (unsigned int i = 0; i < n_dofs; ++i)
          for (unsigned int j = 0; j < i; ++j)
            matrix(j, i) = matrix(i, j);
      }
    };
  } // namespace

  template <int dim>
  MLPreconditioner<dim>::MLPreconditioner(const PotentialSpace<dim> &space)
    : space(space)
  {
    const MPI_Comm communicator = space.mesh.communicator();
    const auto &owned           = space.dof_handler.locally_owned_dofs();
    dealii::DynamicSparsityPattern pattern(space.relevant_dofs);
    dealii::DoFTools::make_sparsity_pattern(space.dof_handler, pattern, space.constraints, false);
    dealii::SparsityTools::distribute_sparsity_pattern(
      pattern, owned, communicator, space.relevant_dofs);
    system_matrix.reinit(owned, owned, pattern, communicator);
  }

  template <int dim>
  void
  MLPreconditioner<dim>::rebuild(const JacobianData<dim> &jacobian)
  {
    assemble(jacobian);

    dealii::TrilinosWrappers::PreconditionAMG::AdditionalData parameters;
    parameters.elliptic              = true;
    parameters.higher_order_elements = true;
    parameters.smoother_type         = "Chebyshev";
    parameters.smoother_sweeps       = 2;
    parameters.aggregation_threshold = 0.02;
    parameters.coarse_type           = "Amesos-KLU";
    amg.clear();
    amg.initialize(system_matrix, parameters);
  }

  template <int dim>
  void
  MLPreconditioner<dim>::assemble(const JacobianData<dim> &jacobian)
  {
    const ElementMatrices<dim> elements(space.fe);
    dealii::FullMatrix<double> matrix(elements.n_dofs, elements.n_dofs);
    dealii::FullMatrix<double> boundary_matrix;

    std::vector<dealii::types::global_dof_index> dofs(elements.n_dofs);
    system_matrix = 0.;
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const unsigned int lattice_cell =
            space.lattice_cell_of_active_cell[cell->active_cell_index()];
          elements.compute(
            jacobian.permeability(lattice_cell), cell->extent_in_direction(0), matrix);
          if (jacobian.boundary.element_matrix(cell, boundary_matrix))
            elements.add_lexicographic(boundary_matrix, matrix);
          cell->get_dof_indices(dofs);
          space.constraints.distribute_local_to_global(matrix, dofs, system_matrix);
        }
    system_matrix.compress(dealii::VectorOperation::add);
  }

  template <int dim>
  void
  MLPreconditioner<dim>::vmult(PotentialVector &dst, const PotentialVector &src) const
  {
    amg.vmult(dst, src);
  }

  template class MLPreconditioner<2>;
  template class MLPreconditioner<3>;
} // namespace magmpm
