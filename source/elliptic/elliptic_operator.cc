#include <deal.II/matrix_free/tools.h>

#include <magmpm/elliptic/elliptic_operator.h>

namespace magmpm
{
  namespace
  {
    constexpr unsigned int n_nodes_1d = potential_degree + 1;

    /**
     * sum_q d_a N_i(q) d_b N_i(q) values(q) for the shape functions N_i of a cell and the points q of a rule,
     * one axis after the other.
     */
    template <int dim, unsigned int n, typename Evaluation, typename Lanes>
    void
    add_diagonal(const Evaluation &u,
                 const unsigned int a,
                 const unsigned int b,
                 const Lanes *values,
                 Lanes *diagonal)
    {
      const auto &shape = u.get_shape_info().data[0];
      Lanes buffers[2][power(static_cast<int>(n_nodes_1d), dim)];
      std::copy_n(values, Evaluation::static_n_q_points, buffers[0]);
      unsigned int n_lines = Evaluation::static_n_q_points / n, stride = 1;
      for (unsigned int axis = 0; axis < dim; ++axis, stride *= n_nodes_1d)
        {
          const Lanes *first  = axis == a ? &shape.shape_gradients[0] : &shape.shape_values[0];
          const Lanes *second = axis == b ? &shape.shape_gradients[0] : &shape.shape_values[0];
          const Lanes *in     = buffers[axis % 2];
          Lanes *out          = buffers[(axis + 1) % 2];
          for (unsigned int line = 0; line < n_lines; ++line)
            for (unsigned int i = 0; i < n_nodes_1d; ++i)
              {
                Lanes sum = typename Lanes::value_type(0.);
                for (unsigned int q = 0; q < n; ++q)
                  sum += first[i * n + q] * second[i * n + q] *
                         in[line % stride + (line / stride * n + q) * stride];
                out[line % stride + (line / stride * n_nodes_1d + i) * stride] = sum;
              }
          n_lines = n_lines / n * n_nodes_1d;
        }
      const Lanes *result = buffers[dim % 2];
      for (int i = 0; i < power(static_cast<int>(n_nodes_1d), dim); ++i)
        diagonal[i] += result[i];
    }
  } // namespace

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::clear()
  {
    media.clear();
    first_matrix.clear();
    coefficients.clear();
    matrices.clear();
    is_at_edge.clear();
    Base::clear();
  }

  template <int dim, typename Number>
  void
  EllipticOperator<dim, Number>::set_coefficient(const Coefficient &coefficient)
  {
    const CellBatches<dim, Number> &cells = *this->data;
    media.assign(cells.n_cell_batches(), invalid_entry);
    coefficients.resize(0);
    for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
      for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
        if (const CellCoefficient<dim> *of_cell = coefficient(batch, lane))
          {
            if (media[batch] == invalid_entry)
              {
                media[batch] = coefficients.size();
                coefficients.push_back(BatchCoefficient());
              }
            BatchCoefficient &of_batch = coefficients[media[batch]];
            of_batch.whole[lane]       = of_cell->whole;
            for (unsigned int q = 0; q < n_octants<dim>; ++q)
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j <= i; ++j)
                  of_batch.octants[q][i][j][lane] = of_cell->octants[q][i][j];
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
  EllipticOperator<dim, Number>::apply_to_cell(Evaluation &u, OctantEvaluation &octants) const
  {
    // integrate() below overwrites the values of the cell.
    const unsigned int batch = u.get_current_cell_index();
    const bool has_boundary  = first_matrix[batch] != invalid_entry;
    const bool has_medium    = media[batch] != invalid_entry;
    Lanes whole              = Number(1.);
    Lanes boundary_part[n_cell_dofs];
    if (has_boundary)
      boundary_product(batch, u.begin_dof_values(), boundary_part);
    if (has_medium)
      {
        octants.reinit(batch);
        octants.evaluate(u.begin_dof_values(), dealii::EvaluationFlags::gradients);
        const BatchCoefficient &coefficient = coefficients[media[batch]];
        whole                               = coefficient.whole;
        for (unsigned int q = 0; q < n_octants<dim>; ++q)
          octants.submit_gradient(coefficient.octants[q] * octants.get_gradient(q), q);
        octants.integrate(dealii::EvaluationFlags::gradients);
      }

    u.evaluate(dealii::EvaluationFlags::gradients);
    for (unsigned int q = 0; q < n_points<dim>; ++q)
      u.submit_gradient(whole * u.get_gradient(q), q);
    u.integrate(dealii::EvaluationFlags::gradients);

    if (has_medium)
      for (unsigned int i = 0; i < n_cell_dofs; ++i)
        u.begin_dof_values()[i] += octants.begin_dof_values()[i];
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
        OctantEvaluation octants(cells, 0, 1);
        for (unsigned int batch = range.first; batch < range.second; ++batch)
          {
            if (edge_only && !is_at_edge[batch])
              continue;
            u.reinit(batch);
            u.read_dof_values(values);
            apply_to_cell(u, octants);
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
  EllipticOperator<dim, Number>::cell_diagonal(const Evaluation &u,
                                               OctantEvaluation &octants,
                                               Lanes *diagonal) const
  {
    const unsigned int batch = u.get_current_cell_index();
    const bool has_medium    = media[batch] != invalid_entry;
    std::fill_n(diagonal, n_cell_dofs, Lanes(Number(0.)));
    // Cells are cubes: the inverse Jacobian is a number.
    for (unsigned int a = 0; a < dim; ++a)
      {
        Lanes values[n_points<dim>];
        for (unsigned int q = 0; q < n_points<dim>; ++q)
          {
            values[q] = u.JxW(q) * (u.inverse_jacobian(q)[a][a] * u.inverse_jacobian(q)[a][a]);
            if (has_medium)
              values[q] *= coefficients[media[batch]].whole;
          }
        add_diagonal<dim, n_points_1d>(u, a, a, values, diagonal);
      }
    if (has_medium)
      {
        octants.reinit(batch);
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int b = 0; b <= a; ++b)
            {
              Lanes values[n_octants<dim>];
              for (unsigned int q = 0; q < n_octants<dim>; ++q)
                {
                  const auto inverse_jacobian = octants.inverse_jacobian(q);
                  values[q]                   = Number(a == b ? 1. : 2.) * octants.JxW(q) *
                              (inverse_jacobian[a][a] * inverse_jacobian[b][b]) *
                              coefficients[media[batch]].octants[q][a][b];
                }
              add_diagonal<dim, n_octants_1d>(octants, a, b, values, diagonal);
            }
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
    OctantEvaluation octants(cells, 0, 1);
    if (cells.get_mg_level() == dealii::numbers::invalid_unsigned_int)
      // Beside hanging nodes it takes the whole element matrix.
      dealii::MatrixFreeTools::
        compute_diagonal<dim, potential_degree, n_points_1d, 1, Number, Lanes, VectorType>(
          cells, diagonal, [this, &octants](Evaluation &u) { apply_to_cell(u, octants); });
    else
      {
        for (unsigned int batch = 0; batch < cells.n_cell_batches(); ++batch)
          {
            u.reinit(batch);
            cell_diagonal(u, octants, u.begin_dof_values());
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
