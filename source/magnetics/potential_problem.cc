#include <magmpm/base/constants.h>
#include <magmpm/magnetics/magnetic_force.h>
#include <magmpm/magnetics/potential_problem.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/reduce.h>
#include <magmpm/surface/force_handover.h>

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
  PotentialProblem<dim>::set_state(const NodeField<dim, NodeContent> &content,
                                   const ExternalField<dim> &sources)
  {
    const parallel::PhaseTimer::Scope section(timer, "Solve potential: material");
    points.reinit(potential.lattice_cells(), content, sources);

    // Weights by |M| in the sources' field alone: the centre then depends on the present state only.
    auto [weight, moment] = points.magnetized_weight();
    parallel::Reduction reduction;
    reduction.sum(weight);
    reduction.sum(moment);
    reduction.carry_out(mesh.communicator());
    Vector<dim> centre = potential.middle();
    for (int d = 0; d < dim && weight > 0.; ++d)
      centre[d] = moment[d] / weight;
    potential.set_boundary(parameters.shielded, centre);
  }

  template <int dim>
  SolveReport
  PotentialProblem<dim>::solve(const NodeField<dim, NodeContent> &content,
                               const ExternalField<dim> &sources)
  {
    potential.follow_mesh();
    set_state(content, sources);
    SolveReport report;
    static_cast<EllipticReport &>(report) = potential.solve(points);
    report.energy                         = -constants::vacuum_permeability * report.minimum;
    report.clipped_fractions              = points.indicator().n_clipped_fractions();
    report.clipped_corrections            = points.indicator().n_clipped_corrections();
    parallel::Reduction reduction;
    reduction.sum(report.clipped_fractions);
    reduction.sum(report.clipped_corrections);
    reduction.carry_out(mesh.communicator());
    return report;
  }

  template <int dim>
  Vector<dim>
  PotentialProblem<dim>::compute_force(const NodeField<dim, SingleScalar> &mass,
                                       NodeField<dim, SingleVector> &force) const
  {
    const parallel::PhaseTimer::Scope section(timer, "Compute magnetic force");
    compute_split_force(potential, points, partition, force);
    // The quadrature ends at a mirror, where stress does not: the force needs that of both sides.
    add_images(
      partition.blocks(), partition.blocks().n_owned(), partition.walls(), Parity(), force);
    return parallel::sum(hand_force_inward(partition, mass, force), mesh.communicator());
  }

  template <int dim>
  void
  PotentialProblem<dim>::compute_field(NodeField<dim, SingleVector> &field) const
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
