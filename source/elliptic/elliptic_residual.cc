#include <magmpm/elliptic/elliptic_residual.h>
#include <magmpm/parallel/reduce.h>

namespace magmpm
{
  template <int dim>
  void
  EllipticResidual<dim>::evaluate(const EllipticSpace<dim> &space,
                                  const EllipticMedium<dim> &medium,
                                  const MediumResponse response,
                                  const EllipticOperator<dim, double> &jacobian,
                                  const PotentialVector &potential,
                                  PotentialVector &residual)
  {
    constexpr unsigned int n_dofs = Operator::n_cell_dofs;
    communicator                  = space.mesh.communicator();
    local_functional              = 0.;
    number_cells(medium, space.lattice_cells.size());

    const auto evaluate_cells = [&](const CellBatches<dim, double> &cells,
                                    PotentialVector &result,
                                    const PotentialVector &values,
                                    const std::pair<unsigned int, unsigned int> &range) {
      typename Operator::Evaluation phi(cells);
      OctantEvaluation octants(cells, 0, 1);
      for (unsigned int batch = range.first; batch < range.second; ++batch)
        {
          phi.reinit(batch);
          phi.read_dof_values(values);
          typename Operator::Lanes boundary_part[n_dofs];
          auto square = jacobian.boundary_product(batch, phi.begin_dof_values(), boundary_part);
          typename Operator::Lanes whole = 1.;
          const bool is_filled = apply_medium(space, medium, response, batch, phi, octants, whole);

          phi.evaluate(dealii::EvaluationFlags::gradients);
          for (unsigned int q = 0; q < n_points<dim>; ++q)
            {
              const auto gradient = phi.get_gradient(q);
              square += whole * (gradient * gradient) * phi.JxW(q);
              phi.submit_gradient(whole * gradient, q);
            }
          for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
            local_functional += 0.5 * square[lane];
          phi.integrate(dealii::EvaluationFlags::gradients);
          for (unsigned int i = 0; i < n_dofs; ++i)
            phi.begin_dof_values()[i] += boundary_part[i];
          for (unsigned int i = 0; is_filled && i < n_dofs; ++i)
            phi.begin_dof_values()[i] += octants.begin_dof_values()[i];
          phi.distribute_local_to_global(result);
        }
    };
    space.matrix_free->template cell_loop<PotentialVector, PotentialVector>(
      evaluate_cells, residual, potential, true);
  }

  template <int dim>
  void
  EllipticResidual<dim>::number_cells(const EllipticMedium<dim> &medium,
                                      const std::size_t n_lattice_cells)
  {
    unsigned int n_filled = 0;
    filled.assign(n_lattice_cells, invalid_entry);
    for (unsigned int cell = 0; cell < n_lattice_cells; ++cell)
      if (medium.fills(cell))
        filled[cell] = n_filled++;
    coefficients.resize(n_filled);
  }

  template <int dim>
  void
  EllipticResidual<dim>::respond(const EllipticMedium<dim> &medium,
                                 const MediumResponse response,
                                 const unsigned int lattice_cell,
                                 OctantVectors<dim> &flux,
                                 const double weight)
  {
    const double s                     = medium.stabilization(lattice_cell);
    const OctantVectors<dim> gradients = flux;
    OctantMatrices<dim> tangent;
    local_functional += medium.respond(lattice_cell, response, flux, tangent);

    CellCoefficient<dim> &coefficient = coefficients[filled[lattice_cell]];
    coefficient.whole                 = 1. + s;
    for (int q = 0; q < n_octants<dim>; ++q)
      {
        local_functional -= 0.5 * s * weight * norm_square(gradients[q]);
        flux[q] -= s * gradients[q];
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j <= i; ++j)
            coefficient.octants[q][i][j] = tangent[q](i, j) - (i == j ? s : 0.);
      }
  }

  template <int dim>
  bool
  EllipticResidual<dim>::apply_medium(const EllipticSpace<dim> &space,
                                      const EllipticMedium<dim> &medium,
                                      const MediumResponse response,
                                      const unsigned int batch,
                                      const typename Operator::Evaluation &values,
                                      OctantEvaluation &phi,
                                      typename Operator::Lanes &whole)
  {
    bool is_filled                                                                      = false;
    std::array<dealii::Tensor<1, dim, typename Operator::Lanes>, n_octants<dim>> fluxes = {};
    for (unsigned int lane = 0; lane < space.matrix_free->n_active_entries_per_cell_batch(batch);
         ++lane)
      {
        const unsigned int cell = space.lattice_cell(batch, lane);
        if (cell == invalid_entry || filled[cell] == invalid_entry)
          continue;
        if (!is_filled)
          {
            phi.reinit(batch);
            phi.evaluate(values.begin_dof_values(), dealii::EvaluationFlags::gradients);
          }
        is_filled = true;

        OctantVectors<dim> flux;
        for (int q = 0; q < n_octants<dim>; ++q)
          for (int d = 0; d < dim; ++d)
            flux[q][d] = phi.get_gradient(q)[d][lane];
        respond(medium, response, cell, flux, phi.JxW(0)[lane]);
        whole[lane] = coefficients[filled[cell]].whole;
        for (int q = 0; q < n_octants<dim>; ++q)
          for (int d = 0; d < dim; ++d)
            fluxes[q][d][lane] = flux[q][d];
      }
    if (is_filled)
      {
        for (int q = 0; q < n_octants<dim>; ++q)
          phi.submit_gradient(fluxes[q], q);
        phi.integrate(dealii::EvaluationFlags::gradients);
      }
    return is_filled;
  }

  template <int dim>
  double
  EllipticResidual<dim>::functional() const
  {
    return parallel::sum(local_functional, communicator);
  }

  template class EllipticResidual<2>;
  template class EllipticResidual<3>;
} // namespace magmpm
