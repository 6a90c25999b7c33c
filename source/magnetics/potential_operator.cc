#include <deal.II/matrix_free/tools.h>

#include <magmpm/magnetics/potential_operator.h>

namespace magmpm
{
  template <int dim, typename Number>
  void
  PotentialOperator<dim, Number>::clear()
  {
    first_tensor.clear();
    first_matrix.clear();
    tensors.clear();
    matrices.clear();
    dealii::MatrixFreeOperators::Base<dim, VectorType>::clear();
  }

  template <int dim, typename Number>
  void
  PotentialOperator<dim, Number>::set_permeability(const CellPermeability &permeability)
  {
    const dealii::MatrixFree<dim, Number> &cells = *this->data;
    first_tensor.assign(cells.n_cell_batches(), invalid_entry);
    tensors.resize(0);
    for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
      for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
        if (const auto *values = permeability(batch, lane))
          {
            if (first_tensor[batch] == invalid_entry)
              {
                first_tensor[batch] = tensors.size();
                dealii::SymmetricTensor<2, dim, Lanes> vacuum;
                for (unsigned int d = 0; d < dim; ++d)
                  vacuum[d][d] = Number(1.);
                tensors.resize(tensors.size() + n_points<dim>, vacuum);
              }
            for (unsigned int q = 0; q < n_points<dim>; ++q)
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j <= i; ++j)
                  tensors[first_tensor[batch] + q][i][j][lane] = values[q][i][j];
          }
  }

  template <int dim, typename Number>
  void
  PotentialOperator<dim, Number>::set_boundary_matrices(const CellMatrix &cell_matrix)
  {
    const dealii::MatrixFree<dim, Number> &cells = *this->data;
    constexpr unsigned int size                  = n_cell_dofs * n_cell_dofs;
    first_matrix.assign(cells.n_cell_batches(), invalid_entry);
    matrices.resize(0);
    for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
      for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
        if (const dealii::FullMatrix<double> *matrix = cell_matrix(batch, lane))
          {
            if (first_matrix[batch] == invalid_entry)
              {
                first_matrix[batch] = matrices.size();
                matrices.resize(matrices.size() + size, Lanes(Number(0.)));
              }
            for (unsigned int i = 0; i < n_cell_dofs; ++i)
              for (unsigned int j = 0; j < n_cell_dofs; ++j)
                matrices[first_matrix[batch] + i * n_cell_dofs + j][lane] = (*matrix)(i, j);
          }
  }

  template <int dim, typename Number>
  typename PotentialOperator<dim, Number>::Lanes
  PotentialOperator<dim, Number>::boundary_product(const unsigned int batch,
                                                   const Lanes *values,
                                                   Lanes *product) const
  {
    std::fill_n(product, n_cell_dofs, Lanes(Number(0.)));
    Lanes quadratic_form = Number(0.);
    if (first_matrix[batch] == invalid_entry)
      return quadratic_form;

    const Lanes *row = matrices.data() + first_matrix[batch];
    for (unsigned int i = 0; i < n_cell_dofs; ++i, row += n_cell_dofs)
      {
        for (unsigned int j = 0; j < n_cell_dofs; ++j)
          product[i] += row[j] * values[j];
        quadratic_form += product[i] * values[i];
      }
    return quadratic_form;
  }

  template <int dim, typename Number>
  void
  PotentialOperator<dim, Number>::apply_to_cell(Evaluation &u) const
  {
    // integrate() below overwrites the values of the cell.
    const unsigned int batch = u.get_current_cell_index();
    Lanes boundary_part[n_cell_dofs];
    boundary_product(batch, u.begin_dof_values(), boundary_part);

    u.evaluate(dealii::EvaluationFlags::gradients);
    if (first_tensor[batch] == invalid_entry)
      for (unsigned int q = 0; q < n_points<dim>; ++q)
        u.submit_gradient(u.get_gradient(q), q);
    else
      for (unsigned int q = 0; q < n_points<dim>; ++q)
        u.submit_gradient(tensors[first_tensor[batch] + q] * u.get_gradient(q), q);
    u.integrate(dealii::EvaluationFlags::gradients);

    for (unsigned int i = 0; i < n_cell_dofs; ++i)
      u.begin_dof_values()[i] += boundary_part[i];
  }

  template <int dim, typename Number>
  void
  PotentialOperator<dim, Number>::apply_add(VectorType &dst, const VectorType &src) const
  {
    this->data->template cell_loop<VectorType, VectorType>(
      [this](const dealii::MatrixFree<dim, Number> &cells,
             VectorType &result,
             const VectorType &values,
             const std::pair<unsigned int, unsigned int> &range) {
        Evaluation u(cells);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            u.reinit(batch);
            u.read_dof_values(values);
            apply_to_cell(u);
            u.distribute_local_to_global(result);
          }
      },
      dst,
      src);
  }

  template <int dim, typename Number>
  void
  PotentialOperator<dim, Number>::compute_diagonal()
  {
    this->inverse_diagonal_entries = std::make_shared<dealii::DiagonalMatrix<VectorType>>();
    VectorType &diagonal           = this->inverse_diagonal_entries->get_vector();
    this->data->initialize_dof_vector(diagonal);
    dealii::MatrixFreeTools::
      compute_diagonal<dim, potential_degree, n_points_1d, 1, Number, Lanes, VectorType>(
        *this->data, diagonal, [this](Evaluation &u) { apply_to_cell(u); });
    this->set_constrained_entries_to_one(diagonal);
    for (auto &entry : diagonal)
      entry = Number(1.) / entry;
  }

  template class PotentialOperator<2, double>;
  template class PotentialOperator<3, double>;
  template class PotentialOperator<2, float>;
  template class PotentialOperator<3, float>;
} // namespace magmpm
