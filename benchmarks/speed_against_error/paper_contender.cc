#include <shared/stopwatch.h>
#include <speed_against_error/contender.h>

#include <cmath>
#include <sstream>

namespace magmpm::benchmarks
{
  namespace
  {
    using paper_scheme::BoxFaces;
    using paper_scheme::PaperScheme;

    std::vector<paper_scheme::Particle<3>>
    make_particles(const Experiment &experiment, const Vector<3> &middle, const bool is_moved)
    {
      const std::vector<Vector<3>> points = experiment.points(middle, is_moved);
      std::vector<paper_scheme::Particle<3>> particles;
      for (const Vector<3> &point : points)
        particles.push_back({point, experiment.volume / points.size(), experiment.content});
      return particles;
    }

    MagneticState
    state_of(const PaperScheme<3> &scheme,
             const std::vector<Vector<3>> &forces,
             const Experiment &experiment,
             const Vector<3> &centre)
    {
      MagneticState state;
      state.moment = scheme.moment();
      state.force  = paper_scheme::total_force(forces);
      state.virial = paper_scheme::virial(scheme.nodes(), forces, centre);

      double square = 0., count = 0.;
      for (const auto &node : scheme.nodes())
        if (norm(node.position - centre) < 0.7 * experiment.radius)
          {
            square += norm_square(node.field() - experiment.exact_field);
            count += 1.;
          }
      state.field_rms = std::sqrt(square / count);
      return state;
    }

    SolveCost
    cost(const paper_scheme::Report &report, const double seconds)
    {
      return {seconds, report.newton.steps, report.newton.linear_iterations};
    }

    Outcome
    run(const Experiment &experiment,
        const double half_width,
        const paper_scheme::Parameters &parameters)
    {
      const int half_cells = static_cast<int>(std::lround(half_width * experiment.resolution));
      const double middle_coordinate = half_cells * experiment.spacing;
      const Vector<3> middle         = {{middle_coordinate, middle_coordinate, middle_coordinate}};
      const ExternalField<3> sources = experiment.sources(middle);
      const auto particles           = make_particles(experiment, middle, false);
      const auto moved_particles     = make_particles(experiment, middle, true);
      Index<3> n_nodes;
      n_nodes.fill(2 * half_cells + 1);

      const Stopwatch cold;
      PaperScheme<3> scheme({}, n_nodes, experiment.spacing, parameters);
      const paper_scheme::Report first = scheme.solve(particles, sources);
      std::vector<Vector<3>> forces    = scheme.forces(sources);
      Outcome outcome;
      outcome.cold       = cost(first, cold.seconds());
      outcome.n_unknowns = first.n_unknowns;
      outcome.state      = state_of(scheme, forces, experiment, experiment.centre(middle, false));

      const Stopwatch warm;
      const paper_scheme::Report second = scheme.solve(moved_particles, sources);
      forces                            = scheme.forces(sources);
      outcome.warm                      = cost(second, warm.seconds());
      return outcome;
    }
  } // namespace

  Contender
  paper_contender(const BoxFaces faces, const double half_width, const double tolerance)
  {
    // Particles stay 2.5 dx away from the faces, wherever the body is in its cell.
    constexpr double margin = 3.2;

    std::ostringstream name;
    name << "paper, " << (faces == BoxFaces::open ? "open" : "Neumann") << " at " << half_width
         << " R";
    return {faces == BoxFaces::open ? Scheme::paper_open : Scheme::paper,
            name.str(),
            [faces, half_width, tolerance](const Experiment &experiment) {
              paper_scheme::Parameters parameters;
              parameters.law              = experiment.law;
              parameters.faces            = faces;
              parameters.newton_tolerance = tolerance;
              return run(experiment, half_width, parameters);
            },
            margin / (half_width - 1.)};
  }
} // namespace magmpm::benchmarks
