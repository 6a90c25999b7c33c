#include <magmpm/lattice/bspline.h>

#include <baselines/paper_scheme/incomplete_cholesky.h>
#include <baselines/paper_scheme/paper_scheme.h>
#include <baselines/paper_scheme/pointwise_preconditioners.h>

#include <chrono>

namespace magmpm::paper_scheme
{
  namespace
  {
    using Clock = std::chrono::steady_clock;

    double
    seconds_since(const Clock::time_point &start)
    {
      return std::chrono::duration<double>(Clock::now() - start).count();
    }
  } // namespace

  template <int dim>
  PaperScheme<dim>::PaperScheme(const Vector<dim> &lower_corner,
                                const Index<dim> &n_nodes,
                                const double spacing,
                                const Parameters &parameters)
    : grid(lower_corner, n_nodes, spacing)
    , parameters(parameters)
    , vacuum(grid)
    , jacobian(grid)
  {
    for (int a = 0; a < dim; ++a)
      if (n_nodes[a] < 6)
        throw InputError("The grid of the paper's scheme has " + std::to_string(n_nodes[a]) +
                         " nodes along axis " + std::to_string(a) + "; it needs 6 or more.");
    reset();
    memory.r.reinit(phi);
    memory.z.reinit(phi);
    memory.p.reinit(phi);
    memory.q.reinit(phi);
  }

  template <int dim>
  void
  PaperScheme<dim>::reset()
  {
    phi.reinit(grid.size(), 2 * grid.stride(dim - 1));
  }

  template <int dim>
  Report
  PaperScheme<dim>::solve(const std::vector<Particle<dim>> &particles,
                          const ExternalField<dim> &sources)
  {
    const auto start = Clock::now();
    material         = material_nodes(grid, particles, sources);
    numbers.clear();
    for (const MaterialNode<dim> &node : material)
      numbers.push_back(grid.number(node.node));
    if (parameters.faces == BoxFaces::open && !material.empty())
      open_faces();

    Report report;
    cg_seconds        = 0.;
    report.n_unknowns = grid.size();
    NodeVector residual, zero;
    residual.reinit(phi);
    zero.reinit(phi);
    evaluate(zero, residual);
    report.zero_residual = residual.l2_norm();

    NewtonParameters newton;
    newton.tolerance = parameters.newton_tolerance * report.zero_residual;
    newton.max_steps = parameters.max_newton_steps;
    newton.is_linear = parameters.law == MagnetizationLaw::linear;
    if (report.zero_residual == 0.)
      phi = zero;
    report.newton        = damped_newton<NodeVector>(*this, newton, phi);
    report.cg_seconds    = cg_seconds;
    report.total_seconds = seconds_since(start);
    return report;
  }

  template <int dim>
  void
  PaperScheme<dim>::open_faces()
  {
    double total = 0.;
    Vector<dim> first_moment;
    for (const MaterialNode<dim> &node : material)
      {
        const double weight = norm(magnetization(parameters.law, node.content, node.source_field));
        total += weight;
        first_moment += weight * node.position;
      }
    if (total > 0.)
      {
        vacuum.open((1. / total) * first_moment);
        jacobian.open((1. / total) * first_moment);
      }
  }

  template <int dim>
  void
  PaperScheme<dim>::evaluate(const NodeVector &x, NodeVector &residual)
  {
    // dx^dim G^T (G phi - M), from -dx^dim G^T (h + M).
    vacuum.apply(x, residual);
    const double factor = std::pow(grid.spacing, dim) / (2. * grid.spacing);
    for (std::size_t k = 0; k < material.size(); ++k)
      {
        MaterialNode<dim> &node = material[k];
        node.self_difference    = central_difference<dim>(grid, x, node.node);
        const Vector<dim> flux  = factor * magnetization_at(node);
        for (int a = 0; a < dim; ++a)
          {
            residual[numbers[k] + grid.stride(a)] -= flux[a];
            residual[numbers[k] - grid.stride(a)] += flux[a];
          }
      }
  }

  template <int dim>
  int
  PaperScheme<dim>::solve_linearized(const NodeVector &residual,
                                     const double relative_tolerance,
                                     NodeVector &step)
  {
    std::vector<MaterialTangent<dim>> tangents;
    for (const MaterialNode<dim> &node : material)
      tangents.push_back(
        {node.node, magnetic_response(parameters.law, node.content, node.field()).tangent});
    jacobian.set_material(tangents);

    switch (parameters.preconditioner)
      {
        case Preconditioner::none:
          return run_cg(IdentityPreconditioner(), residual, relative_tolerance, step);
        case Preconditioner::jacobi:
          {
            JacobiPreconditioner preconditioner;
            preconditioner.reinit(jacobian);
            return run_cg(preconditioner, residual, relative_tolerance, step);
          }
        case Preconditioner::incomplete_cholesky:
          break;
      }
    IncompleteCholesky<dim> preconditioner(grid);
    preconditioner.reinit(jacobian, parameters.modification);
    return run_cg(preconditioner, residual, relative_tolerance, step);
  }

  template <int dim>
  template <typename PreconditionerType>
  int
  PaperScheme<dim>::run_cg(const PreconditionerType &preconditioner,
                           const NodeVector &residual,
                           const double relative_tolerance,
                           NodeVector &step)
  {
    const auto start           = Clock::now();
    NodeVector right_hand_side = residual;
    for (std::ptrdiff_t i = 0; i < grid.size(); ++i)
      right_hand_side[i] = -residual[i];
    if (jacobian.is_singular())
      remove_sublattice_means(grid, right_hand_side);
    const int iterations = conjugate_gradients(jacobian,
                                               preconditioner,
                                               right_hand_side,
                                               relative_tolerance,
                                               parameters.max_cg_iterations,
                                               memory,
                                               step);
    if (jacobian.is_singular())
      remove_sublattice_means(grid, step);
    cg_seconds += seconds_since(start);
    return iterations;
  }

  template <int dim>
  Vector<dim>
  PaperScheme<dim>::moment() const
  {
    Vector<dim> sum;
    for (const MaterialNode<dim> &node : material)
      sum += magnetization_at(node);
    return std::pow(grid.spacing, dim) * sum;
  }

  template <int dim>
  Vector<dim>
  PaperScheme<dim>::field(const Vector<dim> &position, const ExternalField<dim> &sources) const
  {
    const Index<dim> base     = grid.base_node(position);
    const Vector<dim> reduced = grid.reduced(position);
    double weights[dim][stencil_width];
    for (int a = 0; a < dim; ++a)
      quadratic_bspline(reduced[a] - base[a], weights[a]);
    Vector<dim> result = sources.field(position);
    for (int i = 0; i < power(stencil_width, dim); ++i)
      {
        double weight   = 1.;
        Index<dim> node = base;
        for (int a = 0, rest = i; a < dim; ++a, rest /= stencil_width)
          {
            node[a] += rest % stencil_width;
            weight *= weights[a][rest % stencil_width];
          }
        result -= weight * central_difference<dim>(grid, phi, node);
      }
    return result;
  }

  template <int dim>
  std::vector<Vector<dim>>
  PaperScheme<dim>::forces(const ExternalField<dim> &sources, const ForceRegion region) const
  {
    return maxwell_forces(grid, phi, material, parameters.law, sources, region);
  }

  template class PaperScheme<2>;
  template class PaperScheme<3>;
} // namespace magmpm::paper_scheme
