#include <magmpm/particles/hydrostatic_columns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace magmpm
{
  namespace
  {
    /** K of a fluid that weight compresses, else 0 [Pa]. */
    template <int dim>
    double
    yielding_modulus(const BodyParameters<dim> &parameters, const Body<dim> &body)
    {
      const auto *fluid = std::get_if<ViscoelasticFluid<dim>>(&body.material);
      return fluid != nullptr && parameters.initial_state == InitialState::hydrostatic
               ? fluid->bulk_modulus
               : 0.;
    }

    template <int dim>
    double
    highest_point(const Shape<dim> &shape, const Vector<dim> &up, const double spacing)
    {
      double highest = std::numeric_limits<double>::lowest();
      for (const Vector<dim> &point : shape.surface_points(spacing))
        highest = std::max(highest, dot(up, point));
      return highest;
    }
  } // namespace

  double
  pressure_below(const double upper_pressure, const double weight, const double bulk_modulus)
  {
    const double above   = 1. - upper_pressure / bulk_modulus;
    const double squared = above * above - 2. * weight / bulk_modulus;
    return bulk_modulus * (1. - std::sqrt(std::max(squared, 0.)));
  }

  double
  floor_excess(const double distance)
  {
    const double below_half = std::max(0.5 - distance, 0.);
    return 4. * distance * (1. + distance) * below_half * below_half;
  }

  template <int dim>
  HydrostaticColumns<dim>::HydrostaticColumns(const std::vector<BodyParameters<dim>> &parameters,
                                              const std::vector<Body<dim>> &bodies,
                                              const Vector<dim> &gravity,
                                              const Lattice<dim> &lattice,
                                              const std::vector<Obstacle<dim>> &rigid_bodies)
    : lattice(lattice)
    , gravity(gravity)
    , up((-1. / norm(gravity)) * gravity)
    , rigid_bodies(rigid_bodies)
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        std::unique_ptr<Shape<dim>> shape;
        double highest = 0.;
        if (parameters[b].shape.type != ShapeType::points)
          {
            shape   = make_shape(parameters[b].shape);
            highest = highest_point(*shape, up, lattice.spacing);
          }
        contents.push_back({std::move(shape),
                            parameters[b].density,
                            yielding_modulus(parameters[b], bodies[b]),
                            highest});
      }
  }

  template <int dim>
  int
  HydrostaticColumns<dim>::body_at(const Vector<dim> &place, const int below) const
  {
    for (std::size_t b = 0; b < contents.size(); ++b)
      if (contents[b].shape != nullptr && contents[b].shape->contains(place))
        return static_cast<int>(b);
    if (contents[below].bulk_modulus > 0. && dot(up, place) < contents[below].highest)
      for (const Obstacle<dim> &rigid : rigid_bodies)
        if (rigid(place).distance < 0.)
          return below;
    return -1;
  }

  template <int dim>
  std::vector<typename HydrostaticColumns<dim>::Layer>
  HydrostaticColumns<dim>::layers_above(const int body, const Vector<dim> &place) const
  {
    constexpr int n_halvings = 40;
    const double spacing     = lattice.spacing;
    std::vector<Layer> layers;
    int here = body, last_body = body;
    double bottom = 0.; // of the layer
    for (int n = 0; here >= 0 || 0.5 * n * spacing < bottom + spacing; ++n)
      {
        double lower = 0.5 * n * spacing, upper = lower + 0.5 * spacing;
        const int next = body_at(place + upper * up, last_body);
        if (next == here)
          continue;
        for (int halving = 0; halving < n_halvings; ++halving)
          {
            const double middle = 0.5 * (lower + upper);
            (body_at(place + middle * up, last_body) == here ? lower : upper) = middle;
          }
        layers.push_back({here, upper - bottom});
        bottom = upper;
        here   = next;
        if (next >= 0)
          last_body = next;
      }
    return layers;
  }

  template <int dim>
  double
  HydrostaticColumns<dim>::pressure(const std::size_t body,
                                    const Vector<dim> &place,
                                    const bool without_yielding) const
  {
    const double acceleration = norm(gravity);
    const Shape<dim> &shape   = *contents[body].shape;
    Vector<dim> inside        = place;
    if (!shape.contains(place))
      {
        const SurfaceDistance<dim> found = shape.surface_distance(place);
        inside -= (found.distance + 1e-9 * lattice.spacing) * found.normal;
      }
    const std::vector<Layer> layers = layers_above(static_cast<int>(body), inside);
    double pressure                 = 0.;
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
      if (layer->body >= 0)
        {
          const Content &content = contents[layer->body];
          const double weight    = content.density * acceleration * layer->thickness;
          const bool yields      = content.bulk_modulus > 0. &&
                              !(without_yielding && layer->body == static_cast<int>(body));
          pressure = yields ? pressure_below(pressure, weight, content.bulk_modulus)
                            : pressure + weight;
        }
    return std::max(pressure + contents[body].density * acceleration * dot(up, inside - place), 0.);
  }

  template <int dim>
  double
  HydrostaticColumns<dim>::excess_at_walls(const double density, const Vector<dim> &place) const
  {
    double excess = 0.;
    for (int d = 0; d < dim; ++d)
      {
        const double distance = gravity[d] < 0. ? place[d] - lattice.lower_corner[d]
                                                : lattice.upper_corner()[d] - place[d];
        excess += density * std::abs(gravity[d]) * lattice.spacing *
                  floor_excess(distance / lattice.spacing);
      }
    return excess;
  }

  template <int dim>
  Compression
  HydrostaticColumns<dim>::compress(const std::size_t body, ParticleSet<dim> &particles) const
  {
    const Content &content = contents[body];
    double *volumes        = particles.component(ParticleProperty::volume, 0);
    double *masses         = particles.component(ParticleProperty::mass, 0);
    double *ratios         = particles.component(ParticleProperty::deformation, 0);
    Compression compression;
    for (std::size_t p = 0; p < particles.size(); ++p)
      {
        const Vector<dim> place = particles.position(p);
        const double at_rest    = pressure(body, place) + excess_at_walls(content.density, place);
        const double ratio      = std::max(1. - at_rest / content.bulk_modulus, 0.);
        compression.smallest_ratio = std::min(compression.smallest_ratio, ratio);
        if (ratio < Compression::least_ratio)
          {
            compression.largest_weight = std::max(compression.largest_weight,
                                                  pressure(body, place, true));
            continue;
          }
        ratios[p] = ratio;
        volumes[p] /= ratio;
        masses[p] = content.density * volumes[p];
      }
    return compression;
  }

  template class HydrostaticColumns<2>;
  template class HydrostaticColumns<3>;
} // namespace magmpm
