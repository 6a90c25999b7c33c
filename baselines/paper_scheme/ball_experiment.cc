#include <magmpm/base/constants.h>

#include <baselines/paper_scheme/ball_experiment.h>
#include <verification/magnetostatics/sources.h>

#include <random>

namespace magmpm::paper_scheme
{
  template <int dim>
  Vector<dim>
  BallExperiment<dim>::direction()
  {
    if constexpr (dim == 2)
      return {{std::cos(0.35), std::sin(0.35)}};
    else
      return {{0.8 * std::cos(0.35), 0.8 * std::sin(0.35), 0.6}};
  }

  template <int dim>
  Vector<dim>
  BallExperiment<dim>::centre() const
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> offset(-0.5, 0.5);
    Vector<dim> point;
    for (int a = 0; a < dim; ++a)
      point[a] = half_width * radius + offset(random) * spacing();
    return point;
  }

  template <int dim>
  double
  BallExperiment<dim>::volume(const double ball_radius) const
  {
    return (dim == 2 ? constants::pi : 4. / 3. * constants::pi) * std::pow(ball_radius, dim);
  }

  template <int dim>
  std::vector<Particle<dim>>
  BallExperiment<dim>::particles() const
  {
    const double distance = spacing() / particles_per_edge;
    const int reach       = cells_per_radius * particles_per_edge + 2;
    std::mt19937 random(seed + 1000);
    std::uniform_real_distribution<double> jitter(-0.5, 0.5);

    Vector<dim> offset;
    for (int a = 0; a < dim; ++a)
      offset[a] = distance * jitter(random);
    std::vector<Particle<dim>> result;
    for (int i = 0; i < power(2 * reach, dim); ++i)
      {
        Vector<dim> x = offset;
        for (int a = 0, rest = i; a < dim; ++a, rest /= 2 * reach)
          x[a] += (rest % (2 * reach) - reach + 0.5 + jitter(random)) * distance;
        if (norm(x) < radius)
          result.push_back({centre() + x, 0., content});
      }
    for (Particle<dim> &particle : result)
      particle.volume = volume(radius) / result.size();
    return result;
  }

  template <int dim>
  PaperScheme<dim>
  BallExperiment<dim>::scheme(Parameters parameters) const
  {
    parameters.law = law;
    Index<dim> n_nodes;
    n_nodes.fill(static_cast<int>(std::lround(2. * half_width * cells_per_radius)) + 1);
    return PaperScheme<dim>({}, n_nodes, spacing(), parameters);
  }

  template <int dim>
  double
  BallExperiment<dim>::outer_field(const double inner_field) const
  {
    return inner_field + norm(magnetization(law, content, inner_field * direction())) / dim;
  }

  template <int dim>
  ExternalField<dim>
  BallExperiment<dim>::uniform_field(const double strength) const
  {
    return ExternalField<dim>({verification::uniform_source<dim>(strength * direction())});
  }

  template <int dim>
  ExternalField<dim>
  BallExperiment<dim>::dipole(const double distance) const
  {
    return ExternalField<dim>(
      {verification::magnet_source<dim>(centre() + (distance * radius) * direction(),
                                        magnet_radius * radius,
                                        magnet_magnetization * direction())});
  }

  template <int dim>
  typename BallExperiment<dim>::Errors
  BallExperiment<dim>::errors(const PaperScheme<dim> &scheme,
                              const ExternalField<dim> &sources,
                              const double inner_field,
                              const ForceRegion region) const
  {
    const double exact  = norm(magnetization(law, content, inner_field * direction()));
    const double scale  = 0.5 * constants::vacuum_permeability * exact * exact * volume(radius);
    const Vector<dim> e = direction();
    Errors result;
    result.moment = dot(scheme.moment(), e) / (exact * volume(radius)) - 1.;

    double square = 0., count = 0.;
    for (const MaterialNode<dim> &node : scheme.nodes())
      if (norm(node.position - centre()) < 0.7 * radius)
        {
          square += norm_square(node.field() - inner_field * e);
          count += 1.;
        }
    result.field_rms = std::sqrt(square / count) / inner_field;

    // The integral of x_i n_j M_n^2 over the surface is M^2 V/(dim+2) (delta_ij + 2 e_i e_j).
    const std::vector<Vector<dim>> forces = scheme.forces(sources, region);
    const Matrix<dim> moment              = virial(scheme.nodes(), forces, centre());
    const double along                    = dot(e, moment * e);
    const double across                   = (trace(moment) - along) / (dim - 1);
    result.virial_trace                   = trace(moment) / scale - 1.;
    result.virial_deviator                = (along - across) / (scale * 2. / (dim + 2)) - 1.;
    result.net_force                      = norm(total_force(forces)) / (2. * scale / radius);
    return result;
  }

  template <int dim>
  double
  BallExperiment<dim>::exact_dipole_force(const double distance) const
  {
    const double chi    = content.initial_susceptibility;
    const double moment = magnet_magnetization * volume(magnet_radius * radius);
    const double D      = distance * radius;
    if constexpr (dim == 2)
      {
        // The image of a line dipole: at R^2/D, weaker by chi/(chi+2) R^2/D^2.
        const double image = chi / (chi + 2.) * radius * radius / (D * D) * moment;
        return constants::vacuum_permeability * moment * image /
               (constants::pi * std::pow(D - radius * radius / D, 3));
      }
    double sum = 0.;
    for (int k = 1; k < 100; ++k)
      {
        const double inner = moment * (k + 1) / (4. * constants::pi * std::pow(D, k + 2));
        const double outer = inner * k * chi / (k * (chi + 2.) + 1.) * std::pow(radius, 2 * k + 1);
        sum += outer * (k + 1) * (k + 2) / std::pow(D, k + 3);
      }
    return constants::vacuum_permeability * moment * sum;
  }

  template <int dim>
  double
  BallExperiment<dim>::dipole_force_error(const PaperScheme<dim> &scheme,
                                          const ExternalField<dim> &sources,
                                          const double distance,
                                          const ForceRegion region) const
  {
    const double exact = exact_dipole_force(distance);
    return norm(total_force(scheme.forces(sources, region)) - exact * direction()) / exact;
  }

  template struct BallExperiment<2>;
  template struct BallExperiment<3>;
} // namespace magmpm::paper_scheme
