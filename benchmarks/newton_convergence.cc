// Fig. 12 of the paper: how the residual falls in Newton's method, for the paper's scheme and for
// magmpm's own PotentialProblem. A sphere of R = 8 dx near a dipole, 2.2 R from its centre, whose
// field there is that of the Langevin argument a; from zero potential, open faces 4 R away. Both
// solve the linear systems only as exactly as each step needs (forcing_term()).
//
//   newton_convergence > newton_convergence.csv && benchmarks/plot_newton_convergence.py
//
// Writes comma-separated values: scheme, chi_0, a, step, residual over that of zero potential.
//
//   newton_convergence parameter_files/*.prm > scenes.csv &&
//     benchmarks/plot_newton_convergence.py scenes.csv scenes.svg
//
// solves the potential of scenes instead, each as it is at its start, from zero potential (where the
// field is switched on slowly: as it is when the first frame ends). Writes scene, step, residual.

#include <deal.II/base/mpi.h>

#include <magmpm/coupling/magnetic_coupling.h>
#include <magmpm/parallel/phase_timer.h>
#include <magmpm/parallel/ranks.h>
#include <magmpm/parameters/parameters.h>
#include <magmpm/particles/seeding.h>
#include <magmpm/simulation/domain_decomposition.h>

#include <baselines/paper_scheme/ball_experiment.h>
#include <verification/magnetostatics/sampled_setup.h>
#include <verification/magnetostatics/sources.h>

#include <cstdio>
#include <iostream>

using namespace magmpm;
using paper_scheme::BallExperiment;

namespace
{
  constexpr int cells_per_radius = 8;
  constexpr double k2            = 3.31e-5; ///< mu_0 m/(k_B T) of the paper's grains [m/A]
  constexpr double tolerance     = 1e-12;

  BallExperiment<3>
  ball_in_box(const double half_width, const double susceptibility)
  {
    BallExperiment<3> ball;
    ball.cells_per_radius = cells_per_radius;
    ball.half_width       = half_width;
    ball.law              = MagnetizationLaw::langevin;
    ball.content          = {3. * susceptibility / k2, susceptibility};
    return ball;
  }

  /** The magnet, of radius R/2, that makes the field a/k2 at the centre of the ball. */
  ExternalField<3>
  magnet(const BallExperiment<3> &ball, const double a)
  {
    constexpr double radius = 0.5, distance = 2.2;
    const double strength = 1.5 * a / k2 * std::pow(distance / radius, 3);
    return ExternalField<3>(
      {verification::magnet_source<3>(ball.centre() + (distance * ball.radius) * ball.direction(),
                                      radius * ball.radius,
                                      strength * ball.direction())});
  }

  void
  print(const char *scheme,
        const double susceptibility,
        const double a,
        const NewtonReport &newton,
        const double zero_residual)
  {
    for (std::size_t step = 0; step < newton.residuals.size(); ++step)
      std::printf("%s,%g,%g,%zu,%.3e\n",
                  scheme,
                  susceptibility,
                  a,
                  step,
                  newton.residuals[step] / zero_residual);
    std::fprintf(stderr,
                 "%-8s chi_0 = %-4g a = %-3g %d steps, %d halvings, %d CG iterations\n",
                 scheme,
                 susceptibility,
                 a,
                 newton.steps,
                 newton.line_search_steps,
                 newton.linear_iterations);
  }

  void
  run_paper_scheme(const double susceptibility, const double a)
  {
    const BallExperiment<3> ball = ball_in_box(4., susceptibility);
    paper_scheme::Parameters parameters;
    parameters.faces            = paper_scheme::BoxFaces::open;
    parameters.newton_tolerance = tolerance;
    auto scheme                 = ball.scheme(parameters);
    const auto report           = scheme.solve(ball.particles(), magnet(ball, a));
    print("paper", susceptibility, a, report.newton, report.zero_residual);
  }

  void
  run_magmpm(const double susceptibility, const double a)
  {
    const BallExperiment<3> ball = ball_in_box(2., susceptibility);
    MagneticsParameters<3> parameters;
    parameters.solver.newton_tolerance = tolerance;
    // The box of the mechanics, half as wide as that of the potential.
    verification::SampledSetup<3> scene(4 * cells_per_radius, ball.spacing(), 2., parameters);
    scene.set_bodies({verification::sphere<3>(ball.centre(), ball.radius, ball.content)});
    const SolveReport report = scene.problem.solve(scene.content, magnet(ball, a));
    print("magmpm", susceptibility, a, report.newton, report.zero_residual);
  }

  /** The bodies of a scene, seeded. */
  template <int dim>
  std::vector<Body<dim>>
  seeded_bodies(const Parameters<dim> &parameters)
  {
    std::vector<Body<dim>> bodies;
    for (const BodyParameters<dim> &body : parameters.bodies)
      {
        bodies.emplace_back(body, parameters.material_of(body));
        seed_particles(body,
                       parameters.lattice,
                       bodies.size() - 1,
                       parallel::rank(MPI_COMM_WORLD),
                       parallel::n_ranks(MPI_COMM_WORLD),
                       bodies.back());
      }
    return bodies;
  }

  /** The first solve of a scene. */
  template <int dim>
  SolveReport
  first_solve(Parameters<dim> parameters)
  {
    parameters.magnetics.solver.newton_tolerance = tolerance;
    parallel::PhaseTimer timer;
    ExternalField<dim> magnets(parameters.sources);
    std::vector<Body<dim>> bodies = seeded_bodies(parameters);
    DomainDecomposition<dim> decomposition(parameters, MPI_COMM_WORLD);
    SolveTriggerParameters trigger;
    trigger.trigger = SolveTriggerParameters::Trigger::every_step;
    MagneticCoupling<dim> coupling(
      {parameters.lattice, parameters.magnetics, trigger, false}, magnets, timer, MPI_COMM_WORLD);
    coupling.set_up(decomposition.mesh(), decomposition.partition());
    decomposition.regroup(bodies);
    Clock clock;
    for (const double time : {0., parameters.output.frame_interval})
      {
        magnets.set_time(time);
        coupling.update(clock, bodies);
        if (coupling.state().report.zero_residual > 0.)
          break;
        ++clock.step;
      }
    return coupling.state().report;
  }

  template <int dim>
  void
  run_scene(const ParameterFile &file)
  {
    const Parameters<dim> parameters = read_parameters<dim>(file);
    if (!parameters.mesh.carries_potential)
      return;
    const SolveReport report = first_solve(parameters);
    if (parallel::rank(MPI_COMM_WORLD) != 0)
      return;
    const std::string name = file.default_output_directory().substr(std::string("output-").size());
    const auto &residuals  = report.newton.residuals;
    int enough             = -1;
    for (std::size_t step = 0; step < residuals.size(); ++step)
      {
        const double relative = residuals[step] / report.zero_residual;
        std::printf("%s,%zu,%.3e\n", name.c_str(), step, relative);
        if (enough < 0 && relative < 1e-10)
          enough = static_cast<int>(step);
      }
    std::fprintf(stderr,
                 "%-24s %9llu unknowns, below 1e-10 after %d steps, %d CG iterations to %.0e\n",
                 name.c_str(),
                 report.n_unknowns,
                 enough,
                 report.newton.linear_iterations,
                 report.relative_final_residual());
  }

  void
  run_scenes(const int n_files, char **files)
  {
    std::printf("scene,step,relative_residual\n");
    for (int i = 0; i < n_files; ++i)
      {
        const ParameterFile file = read_parameter_file(files[i]);
        if (read_dimension(file) == 2)
          run_scene<2>(file);
        else
          run_scene<3>(file);
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (argc > 1)
    {
      run_scenes(argc - 1, argv + 1);
      return 0;
    }
  std::printf("scheme,susceptibility,argument,step,relative_residual\n");
  for (const double susceptibility : {0.91, 10.})
    for (const double a : {1., 3., 30.})
      {
        run_paper_scheme(susceptibility, a);
        run_magmpm(susceptibility, a);
      }
}
