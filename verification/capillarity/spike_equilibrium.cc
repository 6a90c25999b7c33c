#include <magmpm/base/constants.h>

#include <verification/capillarity/spike_equilibrium.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace magmpm::verification
{
  namespace
  {
    constexpr double mu0 = constants::vacuum_permeability;

    std::vector<double>
    evenly_cut(const double length, const int n)
    {
      std::vector<double> edges;
      for (int i = 0; i <= n; ++i)
        edges.push_back(length * i / n);
      return edges;
    }

    /** A column as it is stretched: fluid over y in [0, 1], vacuum over [1, 2]. */
    struct Stretch
    {
      double reluctivity;         ///< 1/mu
      double by_y, by_x;          ///< derivatives of the height of a point by y and along x
      double by_height, by_slope; ///< of by_y by z, of by_x by z'
    };

    Stretch
    stretch(const FerrofluidLayer &layer, const double y, const double height, const double slope)
    {
      const double mu = mu0 * (1. + layer.medium.initial_susceptibility);
      return y < 1. ? Stretch{1. / mu, layer.depth + height, y * slope, 1., y}
                    : Stretch{1. / mu0, layer.height - height, (2. - y) * slope, -1., 2. - y};
    }
  } // namespace

  SpikeEnergy::SpikeEnergy(const FerrofluidLayer &layer, const LayerField &state, const double k)
    : layer(layer)
    , induction(state.induction())
    , k(k)
    , elements(evenly_cut(constants::pi / k, 6),
               {0., 0.4, 0.7, 0.88, 1., 1.05, 1.15, 1.4, 2.},
               4,
               {true, true, true, true})
    , flat(0.)
  {
    if (layer.law != MagnetizationLaw::linear || layer.faces != FieldFaces::shielded ||
        !std::isfinite(layer.depth + layer.height))
      throw std::invalid_argument(
        "The energy of spikes is that of a linear medium between shielded faces.");
    flat = (*this)({0.}).value;
  }

  double
  SpikeEnergy::magnetic_energy(std::vector<Column> &columns) const
  {
    const std::vector<ElementPoint> &points = elements.points();
    const std::size_t per_column            = points.size() / columns.size();
    std::vector<QuadraticForm> forms;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const Column &column = columns[p / per_column];
        const Stretch s      = stretch(layer, points[p].y, column.height, column.slope);
        // B = (A_y, -A_x); A_x = dA/dx - by_x/by_y dA/dy, A_y = dA/dy/by_y, times the area by_y.
        forms.push_back({s.reluctivity * s.by_y,
                         -s.reluctivity * s.by_x,
                         s.reluctivity * (1. + s.by_x * s.by_x) / s.by_y,
                         -s.reluctivity * s.by_y * induction,
                         s.reluctivity * s.by_x * induction});
      }
    const std::vector<PlaneGradient> change = elements.solve(forms);
    double energy                           = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        Column &column       = columns[p / per_column];
        const Stretch s      = stretch(layer, points[p].y, column.height, column.slope);
        const double upwards = change[p].y / s.by_y;
        const double along   = induction + change[p].x - s.by_x * upwards;
        const double weight  = points[p].weight * s.reluctivity;
        energy += 0.5 * weight * (along * along + upwards * upwards) * s.by_y;
        // A makes E least, so that its change does not count.
        column.by_height += weight * s.by_height *
                            (0.5 * (along * along - upwards * upwards) + along * s.by_x * upwards);
        column.by_slope -= weight * s.by_slope * along * change[p].y;
      }
    return energy;
  }

  ValueAndGradient
  SpikeEnergy::operator()(const std::vector<double> &modes) const
  {
    const std::vector<ElementPoint> &points = elements.points();
    std::vector<Column> columns;
    std::vector<double> weights;
    for (const ElementPoint &point : points)
      {
        if (columns.empty() || point.x != columns.back().x)
          {
            columns.push_back({point.x, 0., 0.});
            weights.push_back(0.);
            for (std::size_t n = 1; n <= modes.size(); ++n)
              {
                columns.back().height += modes[n - 1] / k * std::cos(n * k * point.x);
                columns.back().slope -= modes[n - 1] * n * std::sin(n * k * point.x);
              }
            if (columns.back().height <= -layer.depth || columns.back().height >= layer.height)
              return {std::numeric_limits<double>::infinity(), std::vector<double>(modes.size())};
          }
        weights.back() += 0.5 * point.weight; // over both rectangles, each of height 1
      }
    double energy           = magnetic_energy(columns);
    ValueAndGradient result = {0., std::vector<double>(modes.size(), 0.)};
    const double unit       = layer.surface_tension * constants::pi / k;
    for (std::size_t c = 0; c < columns.size(); ++c)
      {
        Column &column    = columns[c];
        const double area = std::sqrt(1. + column.slope * column.slope);
        const double lift = layer.density * layer.gravity * column.height;
        energy += weights[c] * (0.5 * lift * column.height + layer.surface_tension * area);
        column.by_height += weights[c] * lift;
        column.by_slope += weights[c] * layer.surface_tension * column.slope / area;
        for (std::size_t n = 1; n <= modes.size(); ++n)
          result.gradient[n - 1] += (column.by_height / k * std::cos(n * k * column.x) -
                                     column.by_slope * n * std::sin(n * k * column.x)) /
                                    unit;
      }
    result.value = energy / unit - flat;
    return result;
  }

  double
  SpikeShape::height(const double phase) const
  {
    double sum = 0.;
    for (std::size_t n = 1; n <= modes.size(); ++n)
      sum += modes[n - 1] * std::cos(n * phase);
    return sum;
  }

  SpikeShape
  spike_equilibrium(const FerrofluidLayer &layer,
                    const LayerField &state,
                    const double k,
                    const int n_modes)
  {
    const SpikeEnergy energy(layer, state, k);
    std::vector<double> start(n_modes, 0.);
    start[0] = 0.15 * 2. * constants::pi;
    if (n_modes > 1)
      start[1] = 0.1 * start[0];
    const Minimum minimum = minimize(energy, start, 0.05, 1e-7);
    SpikeShape shape      = {minimum.place, minimum.value};
    for (double &mode : shape.modes)
      mode /= k;
    return shape;
  }
} // namespace magmpm::verification
