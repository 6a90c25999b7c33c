#include <deal.II/base/mpi.h>
#include <magmpm/base/constants.h>
#include <magmpm/magnetics/force_handover.h>
#include <magmpm/magnetics/magnetic_force.h>
#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/mesh/mirror_images.h>
#include <magmpm/parallel/phase_timer.h>

namespace magmpm
{
  template <int dim>
  PotentialProblem<dim>::PotentialProblem(const BackgroundMesh<dim> &mesh,
                                          const BlockPartition<dim> &partition,
                                          const MagneticsParameters<dim> &parameters,
                                          parallel::PhaseTimer &timer)
    : mesh(mesh)
    , partition(partition)
    , parameters(parameters)
    , timer(timer)
    , potential(mesh, parameters.solver, "magnetic potential", timer)
    , points(mesh, partition, parameters)
  {
  }

  template <int dim>
  void
  PotentialProblem<dim>::set_state(const NodeField<dim> &content, const ExternalField<dim> &sources)
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: material");
    points.reinit(potential.lattice_cells(), content, sources);

    // Weights by |M| in the sources' field alone: the centre then depends on the present state only.
    const auto local = points.magnetized_weight();
    std::array<double, dim + 1> sums;
    std::copy_n(local.second.values, dim, sums.begin());
    sums[dim] = local.first;
    dealii::Utilities::MPI::sum(dealii::ArrayView<const double>(sums.data(), sums.size()),
                                mesh.communicator(),
                                dealii::ArrayView<double>(sums.data(), sums.size()));
    Vector<dim> centre = potential.middle();
    for (int d = 0; d < dim && sums[dim] > 0.; ++d)
      centre[d] = sums[d] / sums[dim];
    potential.set_boundary(parameters.shielded, centre);
  }

  template <int dim>
  SolveReport
  PotentialProblem<dim>::solve(const NodeField<dim> &content, const ExternalField<dim> &sources)
  {
    potential.follow_mesh();
    set_state(content, sources);
    SolveReport report;
    static_cast<EllipticReport &>(report) = potential.solve(points);
    report.energy                         = -constants::vacuum_permeability * report.minimum;
    report.clipped_fractions = dealii::Utilities::MPI::sum(points.indicator().n_clipped_fractions(),
                                                           mesh.communicator());
    report.clipped_corrections =
      dealii::Utilities::MPI::sum(points.indicator().n_clipped_corrections(), mesh.communicator());
    return report;
  }

  template <int dim>
  Vector<dim>
  PotentialProblem<dim>::compute_force(const NodeField<dim> &mass, NodeField<dim> &force) const
  {
    const parallel::PhaseTimer::Scope section(timer, "Compute magnetic force");
    compute_split_force(potential, points, partition, force);
    // The quadrature ends at a mirror, where stress does not: the force needs that of both sides.
    add_mirror_images_of_vector(partition, mesh.lattice(), parameters.shielded, force);
    Vector<dim> dropped = hand_force_inward(partition, mass, force);
    partition.update_ghosts(force);
    for (int d = 0; d < dim; ++d)
      dropped[d] = dealii::Utilities::MPI::sum(dropped[d], mesh.communicator());
    return dropped;
  }

  template <int dim>
  void
  PotentialProblem<dim>::compute_field(NodeField<dim> &field) const
  {
    const parallel::PhaseTimer::Scope section(timer, "Compute magnetic force");
    compute_material_field(potential, points, partition, field);
  }

  template <int dim>
  std::vector<MaterialSample<dim>>
  PotentialProblem<dim>::material_samples() const
  {
    return sample_material(potential, points);
  }

  template class PotentialProblem<2>;
  template class PotentialProblem<3>;
} // namespace magmpm
