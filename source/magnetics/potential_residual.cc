#include <magmpm/magnetics/potential_residual.h>
#include <magmpm/parallel/reduce.h>

namespace magmpm
{
  template <int dim>
  void
  PotentialResidual<dim>::evaluate(const PotentialSpace<dim> &space,
                                   const MaterialPoints<dim> &material,
                                   const PotentialOperator<dim, double> &jacobian,
                                   const PotentialVector &potential,
                                   PotentialVector &residual)
  {
    constexpr unsigned int n_dofs = PotentialOperator<dim, double>::n_cell_dofs;
    communicator                  = space.mesh.communicator();
    tensors.resize(material.size());
    local_energy = 0.;

    const auto evaluate_cells = [&](const CellBatches<dim, double> &cells,
                                    PotentialVector &result,
                                    const PotentialVector &values,
                                    const std::pair<unsigned int, unsigned int> &range) {
      typename PotentialOperator<dim, double>::Evaluation phi(cells);
      Fluxes fluxes;
      for (unsigned int batch = range.first; batch < range.second; ++batch)
        {
          phi.reinit(batch);
          phi.read_dof_values(values);
          Lanes boundary_part[n_dofs];
          Lanes energy = jacobian.boundary_product(batch, phi.begin_dof_values(), boundary_part);

          phi.evaluate(dealii::EvaluationFlags::gradients);
          for (unsigned int q = 0; q < n_points<dim>; ++q)
            {
              fluxes[q] = phi.get_gradient(q);
              energy += (fluxes[q] * fluxes[q]) * phi.JxW(q);
            }
          for (unsigned int lane = 0; lane < cells.n_active_entries_per_cell_batch(batch); ++lane)
            {
              local_energy += 0.5 * energy[lane];
              local_energy +=
                subtract_magnetization(material, space.lattice_cell(batch, lane), lane, fluxes);
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
  double
  PotentialResidual<dim>::subtract_magnetization(const MaterialPoints<dim> &material,
                                                 const unsigned int lattice_cell,
                                                 const unsigned int lane,
                                                 Fluxes &fluxes)
  {
    const unsigned int first = material.first_point(lattice_cell);
    if (first == material.none)
      return 0.;

    double coenergy       = 0.;
    const auto self_field = [&fluxes, lane](const int q) {
      Vector<dim> field;
      for (int d = 0; d < dim; ++d)
        field[d] = -fluxes[q][d][lane];
      return field;
    };
    material.for_batches(
      first, self_field, [&](const int first_of_batch, const int n, const auto &batch) {
        const auto &mean = batch.response.mean;
        for (int l = 0; l < n; ++l)
          {
            const int q = first_of_batch + l;
            coenergy += mean.coenergy[l] * material.weight(q);
            for (int i = 0; i < dim; ++i)
              {
                fluxes[q][i][lane] -= mean.magnetization[i][l];
                for (int j = 0; j <= i; ++j)
                  tensors[first + q][i][j] = (i == j ? 1. : 0.) + mean.tangent(i, j)[l];
              }
          }
      });
    return coenergy;
  }

  template <int dim>
  double
  PotentialResidual<dim>::energy() const
  {
    return parallel::sum(local_energy, communicator);
  }

  template class PotentialResidual<2>;
  template class PotentialResidual<3>;
} // namespace magmpm
