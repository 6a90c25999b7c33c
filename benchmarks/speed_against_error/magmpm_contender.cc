#include <shared/stopwatch.h>
#include <speed_against_error/contender.h>

#include <verification/magnetostatics/particle_setup.h>

#include <algorithm>
#include <cmath>

namespace magmpm::benchmarks
{
  using namespace verification;

  namespace
  {
    /** Edge of the mechanical box in dx: that of the potential is twice as wide. */
    int
    box_cells(const int resolution)
    {
      return std::max(16, 8 * static_cast<int>(std::ceil(4. * resolution / 8.)));
    }

    Lattice<3>
    make_lattice(const Experiment &experiment)
    {
      Lattice<3> lattice;
      lattice.spacing = experiment.spacing;
      lattice.n_cells.fill(box_cells(experiment.resolution));
      return lattice;
    }

    PointBody<3>
    make_body(const Experiment &experiment, const Vector<3> &middle, const bool is_moved)
    {
      constexpr double number_density = 1e24; ///< of grains; no figure depends on it
      PointBody<3> body;
      body.points   = experiment.points(middle, is_moved);
      body.volume   = experiment.volume;
      body.magnetic = {experiment.content.saturation_magnetization,
                       experiment.content.initial_susceptibility,
                       number_density};
      return body;
    }

    MagneticState
    state_of(const ParticleSetup<3> &setup, const Experiment &experiment, const Vector<3> &centre)
    {
      MagneticState state;
      state.moment = setup.moment();
      state.force  = setup.force();
      state.virial = setup.virial(centre);

      double square = 0., volume = 0.;
      for (const MaterialSample<3> &sample : setup.samples())
        if (norm(sample.position - centre) < 0.7 * experiment.radius)
          {
            square += sample.weight * norm_square(sample.field - experiment.exact_field);
            volume += sample.weight;
          }
      state.field_rms = std::sqrt(square / volume);
      return state;
    }

    SolveCost
    cost(const SolveReport &report, const double seconds)
    {
      return {seconds, report.newton.steps, report.newton.linear_iterations};
    }

    Outcome
    run(const Experiment &experiment,
        const MeshParameters<3> &mesh,
        const MagneticsParameters<3> &magnetics)
    {
      const Lattice<3> lattice       = make_lattice(experiment);
      const Vector<3> middle         = 0.5 * lattice.upper_corner();
      const ExternalField<3> sources = experiment.sources(middle);
      const PointBody<3> body        = make_body(experiment, middle, false);

      const Stopwatch cold;
      ParticleSetup<3> setup(MPI_COMM_SELF, lattice, mesh, magnetics);
      setup.set_bodies({body});
      const SolveReport first = setup.solve(sources);
      Outcome outcome;
      outcome.cold       = cost(first, cold.seconds());
      outcome.n_unknowns = first.n_unknowns;
      outcome.state      = state_of(setup, experiment, experiment.centre(middle, false));

      setup.set_bodies({make_body(experiment, middle, true)});
      const Stopwatch warm;
      const SolveReport second = setup.solve(sources);
      outcome.warm             = cost(second, warm.seconds());
      return outcome;
    }

    const char *
    name_of(const Preconditioner preconditioner)
    {
      switch (preconditioner)
        {
          case Preconditioner::gmg:
            return "GMG";
          case Preconditioner::ml:
            return "ML";
          case Preconditioner::muelu:
            return "MueLu";
        }
      return "";
    }
  } // namespace

  Contender
  magmpm_contender(const Preconditioner preconditioner,
                   const int cell_edge,
                   const MaterialIndicator indicator,
                   const double tolerance)
  {
    MeshParameters<3> mesh;
    mesh.cell_edge = cell_edge;
    MagneticsParameters<3> magnetics;
    magnetics.solver.preconditioner   = preconditioner;
    magnetics.indicator               = indicator;
    magnetics.solver.newton_tolerance = tolerance;
    return {Scheme::magmpm,
            std::string(name_of(preconditioner)) + (cell_edge == 2 ? ", 2 dx, " : ", dx, ") +
              (indicator == MaterialIndicator::sharp ? "sharp" : "smeared"),
            [mesh, magnetics](const Experiment &experiment) {
              MagneticsParameters<3> parameters = magnetics;
              parameters.law                    = experiment.law;
              return run(experiment, mesh, parameters);
            }};
  }
} // namespace magmpm::benchmarks
