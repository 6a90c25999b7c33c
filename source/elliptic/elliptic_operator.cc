#include <deal.II/matrix_free/tools.h>

#include <magmpm/elliptic/elliptic_operator.h>

namespace magmpm
{
  namespace
  {
    /** Values at points to values at nodes along one axis, in place; @p matrix[node][point]. */
    template <typename Lanes, std::size_t n_values>
    void
    contract(const Lanes *matrix, const unsigned int stride, Lanes (&values)[n_values])
    {
      constexpr unsigned int n = n_points_1d;
      for (unsigned int line = 0; line < n_values / n; ++line)
        {
          Lanes *first = values + line % stride + line / stride * stride * n;
          Lanes in[n];
          for (unsigned int q = 0; q < n; ++q)
            in[q] = first[q * stride];
          for (unsigned int i = 0; i < n; ++i)
            {
              first[i * stride] = matrix[i * n] * in[0];
              for (unsigned int q = 1; q < n; ++q)
                first[i * stride] += matrix[i * n + q] * in[q];
            }
        }
    }
  } // namespace

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::clear()
  {
    first_tensor.clear();
    first_matrix.clear();
    tensors.clear();
    matrices.clear();
    is_at_edge.clear();
    Base::clear();
  }

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::set_coefficient(const CellCoefficient &coefficient)
  {
    const CellBatches<dim, Number> &cells = *this->data;
    first_tensor.assign(cells.n_cell_batches(), invalid_entry);
    tensors.resize(0);
    for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
      for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
        if (const auto *values = coefficient(batch, lane))
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
  EllipticOperator<dim, Number>::set_boundary_matrices(const CellMatrix &cell_matrix)
  {
    const CellBatches<dim, Number> &cells = *this->data;
    constexpr unsigned int size           = n_cell_dofs * n_cell_dofs;
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
  typename EllipticOperator<dim, Number>::Lanes
  EllipticOperator<dim, Number>::boundary_product(const unsigned int batch,
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
  EllipticOperator<dim, Number>::apply_to_cell(Evaluation &u) const
  {
    // integrate() below overwrites the values of the cell.
    const unsigned int batch = u.get_current_cell_index();
    const bool has_boundary  = first_matrix[batch] != invalid_entry;
    Lanes boundary_part[n_cell_dofs];
    if (has_boundary)
      boundary_product(batch, u.begin_dof_values(), boundary_part);

    u.evaluate(dealii::EvaluationFlags::gradients);
    if (first_tensor[batch] == invalid_entry)
      for (unsigned int q = 0; q < n_points<dim>; ++q)
        u.submit_gradient(u.get_gradient(q), q);
    else
      for (unsigned int q = 0; q < n_points<dim>; ++q)
        u.submit_gradient(tensors[first_tensor[batch] + q] * u.get_gradient(q), q);
    u.integrate(dealii::EvaluationFlags::gradients);

    if (has_boundary)
      for (unsigned int i = 0; i < n_cell_dofs; ++i)
        u.begin_dof_values()[i] += boundary_part[i];
  }

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::apply_add(VectorType &dst, const VectorType &src) const
  {
    this->data->template cell_loop<VectorType, VectorType>(
      [this](const CellBatches<dim, Number> &cells,
             VectorType &result,
             const VectorType &values,
             const std::pair<unsigned int, unsigned int> &range) {
        Evaluation u(cells);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            if (edge_only && !is_at_edge[batch])
              continue;
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
  EllipticOperator<dim, Number>::initialize_level(
    const std::shared_ptr<const CellBatches<dim, Number>> &cells,
    const dealii::MGConstrainedDoFs &constraints,
    const unsigned int level)
  {
    this->initialize(cells, constraints, level);

    VectorType is_edge;
    cells->initialize_dof_vector(is_edge);
    for (const auto dof : constraints.get_refinement_edge_indices(level))
      if (is_edge.in_local_range(dof))
        is_edge(dof) = Number(1.);
    is_edge.update_ghost_values();
    Evaluation u(*cells);
    is_at_edge.assign(cells->n_cell_batches(), false);
    for (unsigned int batch = 0; batch < cells->n_cell_batches(); ++batch)
      {
        u.reinit(batch);
        u.read_dof_values(is_edge);
        for (unsigned int i = 0; i < n_cell_dofs; ++i)
          for (unsigned int lane = 0; lane < Lanes::size(); ++lane)
            if (u.begin_dof_values()[i][lane] != Number(0.))
              is_at_edge[batch] = true;
      }
  }

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::vmult_interface_down(VectorType &dst, const VectorType &src) const
  {
    edge_only = true;
    Base::vmult_interface_down(dst, src);
    edge_only = false;
  }

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::vmult_interface_up(VectorType &dst, const VectorType &src) const
  {
    edge_only = true;
    Base::vmult_interface_up(dst, src);
    edge_only = false;
  }

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::cell_diagonal(const Evaluation &u, Lanes *diagonal) const
  {
    constexpr unsigned int n = n_points_1d;
    static_assert(n == potential_degree + 1, "contractions are done in place");

    // Of two shape functions or derivatives in one dimension, by the number of derivatives.
    const auto &shape = u.get_shape_info().data[0];
    Lanes products[3][n * n];
    for (unsigned int i = 0; i < n * n; ++i)
      {
        products[0][i] = shape.shape_values[i] * shape.shape_values[i];
        products[1][i] = shape.shape_values[i] * shape.shape_gradients[i];
        products[2][i] = shape.shape_gradients[i] * shape.shape_gradients[i];
      }

    const unsigned int batch = u.get_current_cell_index();
    const bool is_vacuum     = first_tensor[batch] == invalid_entry;
    std::fill_n(diagonal, n_cell_dofs, Lanes(Number(0.)));
    for (unsigned int a = 0; a < dim; ++a)
      for (unsigned int b = is_vacuum ? a : 0; b <= a; ++b)
        {
          Lanes values[n_points<dim>];
          for (unsigned int q = 0; q < n_points<dim>; ++q)
            {
              const auto inverse_jacobian = u.inverse_jacobian(q); // cells are cubes
              values[q]                   = Number(a == b ? 1. : 2.) * u.JxW(q) *
                          (inverse_jacobian[a][a] * inverse_jacobian[b][b]);
              if (!is_vacuum)
                values[q] *= tensors[first_tensor[batch] + q][a][b];
            }
          for (unsigned int axis = 0, stride = 1; axis < dim; ++axis, stride *= n)
            contract(products[(axis == a) + (axis == b)], stride, values);
          for (unsigned int i = 0; i < n_cell_dofs; ++i)
            diagonal[i] += values[i];
        }
    if (first_matrix[batch] != invalid_entry)
      for (unsigned int i = 0; i < n_cell_dofs; ++i)
        diagonal[i] += matrices[first_matrix[batch] + i * (n_cell_dofs + 1)];
  }

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::compute_diagonal()
  {
    const CellBatches<dim, Number> &cells = *this->data;
    this->inverse_diagonal_entries        = std::make_shared<dealii::DiagonalMatrix<VectorType>>();
    VectorType &diagonal                  = this->inverse_diagonal_entries->get_vector();
    cells.initialize_dof_vector(diagonal);
    Evaluation u(cells);
    if (cells.get_mg_level() == dealii::numbers::invalid_unsigned_int)
      // Beside hanging nodes it takes the whole element matrix.
      dealii::MatrixFreeTools::
        compute_diagonal<dim, potential_degree, n_points_1d, 1, Number, Lanes, VectorType>(
          cells, diagonal, [this](Evaluation &u) { apply_to_cell(u); });
    else
      {
        for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
          {
            u.reinit(batch);
            cell_diagonal(u, u.begin_dof_values());
            u.distribute_local_to_global(diagonal);
          }
        diagonal.compress(dealii::VectorOperation::add);
      }
    this->set_constrained_entries_to_one(diagonal);
    for (auto &entry : diagonal)
      entry = Number(1.) / entry;
  }

  template class EllipticOperator<2, double>;
  template class EllipticOperator<3, double>;
  template class EllipticOperator<2, float>;
  template class EllipticOperator<3, float>;
} // namespace magmpm
