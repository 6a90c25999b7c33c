#include <magmpm/elliptic/elliptic_residual.h>
#include <magmpm/parallel/reduce.h>

namespace magmpm
{
  template <int dim>
  void
  EllipticResidual<dim>::evaluate(const EllipticSpace<dim> &space,
                                  const EllipticMedium<dim> &medium,
                                  const EllipticOperator<dim, double> &jacobian,
                                  const PotentialVector &potential,
                                  PotentialVector &residual)
  {
    constexpr unsigned int n_dofs = EllipticOperator<dim, double>::n_cell_dofs;
    communicator                  = space.mesh.communicator();
    local_functional              = 0.;
    number_tensors(medium, space.lattice_cells.size());

    const auto evaluate_cells = [&](const CellBatches<dim, double> &cells,
                                    PotentialVector &result,
                                    const PotentialVector &values,
                                    const std::pair<unsigned int, unsigned int> &range) {
      typename EllipticOperator<dim, double>::Evaluation phi(cells);
      Fluxes fluxes;
      for (unsigned int batch = range.first; batch < range.second; ++batch)
        {
          phi.reinit(batch);
          phi.read_dof_values(values);
          Lanes boundary_part[n_dofs];
          Lanes square = jacobian.boundary_product(batch, phi.begin_dof_values(), boundary_part);

          phi.evaluate(dealii::EvaluationFlags::gradients);
          for (unsigned int q = 0; q < n_points<dim>; ++q)
            {
              fluxes[q] = phi.get_gradient(q);
              square += (fluxes[q] * fluxes[q]) * phi.JxW(q);
            }
          for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
            {
              local_functional += 0.5 * square[lane];
              local_functional +=
                apply_medium(medium, space.lattice_cell(batch, lane), lane, fluxes);
            }
          for (unsigned int q = 0; q < n_points<dim>; ++q)
            phi.submit_gradient(fluxes[q], q);
          phi.integrate(dealii::EvaluationFlags::gradients);
          for (unsigned int i = 0; i < n_dofs; ++i)
            phi.begin_dof_values()[i] += boundary_part[i];
          phi.distribute_local_to_global(result);
        }
    };
    space.matrix_free->template cell_loop<PotentialVector, PotentialVector>(
      evaluate_cells, residual, potential, true);
  }

  template <int dim>
  void
  EllipticResidual<dim>::number_tensors(const EllipticMedium<dim> &medium,
                                        const std::size_t n_lattice_cells)
  {
    unsigned int n_tensors = 0;
    first_tensor.assign(n_lattice_cells, invalid_entry);
    for (unsigned int cell = 0; cell < n_lattice_cells; ++cell)
      if (medium.fills(cell))
        {
          first_tensor[cell] = n_tensors;
          n_tensors += n_points<dim>;
        }
    tensors.resize(n_tensors);
  }

  template <int dim>
  double
  EllipticResidual<dim>::apply_medium(const EllipticMedium<dim> &medium,
                                      const unsigned int lattice_cell,
                                      const unsigned int lane,
                                      Fluxes &fluxes)
  {
    if (lattice_cell == invalid_entry || first_tensor[lattice_cell] == invalid_entry)
      return 0.;

    PointVectors<dim> flux;
    PointMatrices<dim> tangent;
    for (int q = 0; q < n_points<dim>; ++q)
      for (int d = 0; d < dim; ++d)
        flux[q][d] = fluxes[q][d][lane];
    const double energy = medium.respond(lattice_cell, flux, tangent);
    for (int q = 0; q < n_points<dim>; ++q)
      for (int i = 0; i < dim; ++i)
        {
          fluxes[q][i][lane] = flux[q][i];
          for (int j = 0; j <= i; ++j)
            tensors[first_tensor[lattice_cell] + q][i][j] = tangent[q](i, j);
        }
    return energy;
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
