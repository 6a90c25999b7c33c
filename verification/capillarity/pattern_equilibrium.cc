#include <magmpm/base/constants.h>

#include <verification/capillarity/pattern_equilibrium.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace magmpm::verification
{
  namespace
  {
    constexpr double pi  = constants::pi;
    constexpr double mu0 = constants::vacuum_permeability;

    using Values = std::vector<double>;

    double
    product(const Values &a, const Values &b)
    {
      return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    }

    /** Fluid over s in [0, 1], vacuum over [1, 2]; finer at the surface. */
    const Values edges = {0., 0.5, 0.82, 1., 1.06, 1.2, 1.5, 2.};

    constexpr int degree = 4;

    /** A point of a stretched column. */
    struct Stretch
    {
      bool is_fluid;
      double by_s;           ///< height over s
      double share;          ///< part of the slopes of the surface that are those of the point
      double lean_x, lean_y; ///< slopes of the point
    };

    Stretch
    stretch(const FerrofluidLayer &layer, const double s, const std::array<double, 3> &surface)
    {
      const double share = s < 1. ? s : 2. - s;
      return {s < 1.,
              s < 1. ? layer.depth + surface[0] : layer.height - surface[0],
              share,
              share * surface[1],
              share * surface[2]};
    }

    /** The gradient in space of one over the box. */
    Vector<3>
    in_space(const Stretch &s, const BoxGradient &g)
    {
      const double up = g[2] / s.by_s;
      return {{g[0] - s.lean_x * up, g[1] - s.lean_y * up, up}};
    }

    /** The flux through the box, times the volume of the point, of one in space. */
    BoxGradient
    in_box(const Stretch &s, const Vector<3> &q, const double weight)
    {
      return {weight * s.by_s * q[0],
              weight * s.by_s * q[1],
              weight * (q[2] - s.lean_x * q[0] - s.lean_y * q[1])};
    }

    /** At a point: |h|^2/2 + psi, grad phi - M and I + dM/dH. */
    struct Response
    {
      double energy;
      Vector<3> flux;
      Matrix<3> tangent;
    };

    Response
    response(const FerrofluidLayer &layer,
             const bool is_fluid,
             const double outer,
             const Vector<3> &gradient)
    {
      Response result = {0.5 * norm_square(gradient), gradient, identity<3>()};
      if (is_fluid)
        {
          const Vector<3> field = Vector<3>{{0., 0., outer}} - gradient;
          const auto medium     = magnetic_response(layer.law, layer.medium, field);
          result.energy += medium.coenergy;
          result.flux -= medium.magnetization;
          result.tangent += medium.tangent;
        }
      return result;
    }

    /** mu/mu_0 along the column, of the flat layer. */
    Values
    flat_permeability(const CosineElements &elements, const double of_fluid)
    {
      Values result;
      for (const CosineElements::Height &height : elements.column())
        result.push_back(height.s < 1. ? of_fluid : 1.);
      return result;
    }

    /** The flat layer's, stretched. */
    LayeredMatrix
    flat_matrix_of(const CosineElements &elements,
                   const FerrofluidLayer &layer,
                   const LayerField &state)
    {
      Values across = flat_permeability(elements, 1. + state.magnetization / state.field);
      Values along  = flat_permeability(elements, 1. + state.slope);
      for (std::size_t q = 0; q < across.size(); ++q)
        {
          const double thickness = elements.column()[q].s < 1. ? layer.depth : layer.height;
          across[q] *= thickness;
          along[q] /= thickness;
        }
      return LayeredMatrix(elements, across, along);
    }
    /** The flux of a linear medium through the box: tangent . gradient. */
    std::vector<BoxGradient>
    linear_flux(const std::vector<BoxPoint> &points,
                const std::vector<Stretch> &stretches,
                const std::vector<Response> &responses,
                const std::vector<BoxGradient> &gradients)
    {
      std::vector<BoxGradient> flux;
      for (std::size_t p = 0; p < points.size(); ++p)
        flux.push_back(in_box(stretches[p],
                              responses[p].tangent * in_space(stretches[p], gradients[p]),
                              points[p].weight));
      return flux;
    }

    /** Conjugate gradients for a step of Newton's method, which is taken from the gradients. */
    void
    take_step(const CosineElements &elements,
              const LayeredMatrix &flat_matrix,
              const std::vector<Stretch> &stretches,
              const std::vector<Response> &responses,
              Values residual,
              std::vector<BoxGradient> &gradients)
    {
      Values z = flat_matrix.solve(residual), direction = z;
      double rz         = product(residual, z);
      const double goal = 1e-18 * rz;
      for (int i = 0; i < 200 && rz > goal; ++i)
        {
          const std::vector<BoxGradient> slopes = elements.gradients(direction);
          const Values image =
            elements.tested(linear_flux(elements.points(), stretches, responses, slopes));
          const double length = rz / product(direction, image);
          for (std::size_t u = 0; u < residual.size(); ++u)
            residual[u] -= length * image[u];
          for (std::size_t p = 0; p < slopes.size(); ++p)
            for (int d = 0; d < 3; ++d)
              gradients[p][d] -= length * slopes[p][d];
          z                 = flat_matrix.solve(residual);
          const double next = product(residual, z), ratio = next / rz;
          rz = next;
          for (std::size_t u = 0; u < residual.size(); ++u)
            direction[u] = z[u] + ratio * direction[u];
        }
    }

    /** Newton's method. @param gradients  in the box, of the potential to start with, then of the solution. */
    std::vector<Response>
    solve_potential(const CosineElements &elements,
                    const LayeredMatrix &flat_matrix,
                    const FerrofluidLayer &layer,
                    const double outer,
                    const std::vector<Stretch> &stretches,
                    std::vector<BoxGradient> &gradients)
    {
      const std::vector<BoxPoint> &points = elements.points();
      std::vector<Response> responses(points.size());
      std::vector<BoxGradient> flux(points.size());
      double first = 0.;
      for (int step = 0; step < 30; ++step)
        {
          for (std::size_t p = 0; p < points.size(); ++p)
            {
              const Stretch &s = stretches[p];
              responses[p]     = response(layer, s.is_fluid, outer, in_space(s, gradients[p]));
              flux[p]          = in_box(s, responses[p].flux, points[p].weight);
            }
          const Values residual = elements.tested(flux);
          const double size     = std::sqrt(product(residual, residual));
          first                 = step == 0 ? size : first;
          if (size <= 1e-9 * first)
            break;
          take_step(elements, flat_matrix, stretches, responses, residual, gradients);
        }
      return responses;
    }
  } // namespace

  PatternEnergy::PatternEnergy(const FerrofluidLayer &layer,
                               const LayerField &state,
                               const double k,
                               const Pattern pattern,
                               const int n_modes,
                               const int n_cosines)
    : layer(layer)
    , state(state)
    , k(k)
    , elements({2. * pi / (std::sqrt(3.) * k), 2. * pi / k},
               {pattern == Pattern::ridges ? 1 : static_cast<int>(n_cosines / std::sqrt(3.)) + 1,
                n_cosines},
               edges,
               degree)
    , flat_matrix(flat_matrix_of(elements, layer, state))
  {
    if (layer.faces != FieldFaces::shielded || !std::isfinite(layer.depth + layer.height))
      throw std::invalid_argument(
        "The energy of patterns is that of a layer between shielded faces.");
    // Waves (i pi/width_x, j pi/width_y) by the square of their wave number, (3 i^2 + j^2)/4 k^2.
    std::map<int, std::vector<Wave>> shells;
    constexpr int most = 9;
    for (int i = 0; i <= (pattern == Pattern::ridges ? 0 : most); ++i)
      for (int j = i % 2; j <= 2 * most; j += 2)
        if (i + j > 0 && 3 * i * i + j * j <= 4 * most * most)
          shells[3 * i * i + j * j].push_back(
            {0.5 * std::sqrt(3.) * i * k, 0.5 * j * k, i > 0 && j > 0 ? 2. : 1.});
    for (auto shell = shells.begin(); static_cast<int>(modes_waves.size()) < n_modes; ++shell)
      {
        double sum = 0.;
        for (const Wave &wave : shell->second)
          sum += wave.factor;
        for (Wave &wave : shell->second)
          wave.factor /= sum;
        modes_waves.push_back(shell->second);
      }
    flat = (*this)(Values(n_modes, 0.)).value;
  }

  double
  PatternEnergy::height(const std::vector<double> &modes, const double x, const double y) const
  {
    double sum = 0.;
    for (std::size_t n = 0; n < modes.size(); ++n)
      for (const Wave &wave : modes_waves[n])
        sum += modes[n] / k * wave.factor * std::cos(wave.kx * x) * std::cos(wave.ky * y);
    return sum;
  }

  std::vector<PatternEnergy::Column>
  PatternEnergy::columns_of(const std::vector<double> &modes) const
  {
    std::vector<Column> columns;
    for (std::size_t p = 0; p < elements.points().size(); p += elements.points_per_column())
      {
        const BoxPoint &point = elements.points()[p];
        Column column         = {point.x, point.y, {}, {}};
        for (std::size_t n = 0; n < modes.size(); ++n)
          for (const Wave &wave : modes_waves[n])
            {
              const double size = modes[n] / k * wave.factor;
              const double cx = std::cos(wave.kx * point.x), cy = std::cos(wave.ky * point.y);
              column.surface[0] += size * cx * cy;
              column.surface[1] -= size * wave.kx * std::sin(wave.kx * point.x) * cy;
              column.surface[2] -= size * wave.ky * cx * std::sin(wave.ky * point.y);
            }
        columns.push_back(column);
      }
    return columns;
  }

  double
  PatternEnergy::magnetic_energy(std::vector<Column> &columns) const
  {
    const std::vector<BoxPoint> &points = elements.points();
    const std::size_t per_column        = elements.points_per_column();
    const double outer                  = state.field + state.magnetization;
    std::vector<Stretch> stretches;
    for (std::size_t p = 0; p < points.size(); ++p)
      stretches.push_back(stretch(layer, points[p].s, columns[p / per_column].surface));

    std::vector<BoxGradient> gradients(points.size(), BoxGradient{});
    const std::vector<Response> responses =
      solve_potential(elements, flat_matrix, layer, outer, stretches, gradients);

    double energy = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const Stretch &s    = stretches[p];
        const Vector<3> &q  = responses[p].flux;
        const double up     = gradients[p][2] / s.by_s;
        const double weight = -mu0 / layer.surface_tension * points[p].weight;
        energy += weight * s.by_s * responses[p].energy;
        // phi makes it stationary, so that its change does not count.
        std::array<double, 3> &cost = columns[p / per_column].cost;
        cost[0] += (s.is_fluid ? weight : -weight) *
                   (responses[p].energy + (q[0] * s.lean_x + q[1] * s.lean_y - q[2]) * up);
        cost[1] -= weight * s.share * q[0] * gradients[p][2];
        cost[2] -= weight * s.share * q[1] * gradients[p][2];
      }
    return energy;
  }

  ValueAndGradient
  PatternEnergy::operator()(const std::vector<double> &modes) const
  {
    std::vector<Column> columns = columns_of(modes);
    for (const Column &column : columns)
      if (column.surface[0] <= -layer.depth || column.surface[0] >= layer.height)
        return {std::numeric_limits<double>::infinity(), Values(modes.size())};
    ValueAndGradient result = {magnetic_energy(columns), Values(modes.size(), 0.)};
    const double area       = elements.direction(0).width * elements.direction(1).width;
    const double weight     = area / static_cast<double>(columns.size());
    const double lift       = layer.density * layer.gravity / layer.surface_tension;
    for (Column &column : columns)
      {
        const auto [z, by_x, by_y] = column.surface;
        const double tilt          = std::sqrt(1. + by_x * by_x + by_y * by_y);
        result.value += weight * (0.5 * lift * z * z + tilt);
        column.cost[0] += weight * lift * z;
        column.cost[1] += weight * by_x / tilt;
        column.cost[2] += weight * by_y / tilt;
        for (std::size_t n = 0; n < modes.size(); ++n)
          for (const Wave &wave : modes_waves[n])
            {
              const double cx = std::cos(wave.kx * column.x), cy = std::cos(wave.ky * column.y);
              result.gradient[n] += wave.factor / (k * area) *
                                    (column.cost[0] * cx * cy -
                                     column.cost[1] * wave.kx * std::sin(wave.kx * column.x) * cy -
                                     column.cost[2] * wave.ky * cx * std::sin(wave.ky * column.y));
            }
      }
    result.value = result.value / area - flat;
    return result;
  }

  PatternShape
  pattern_equilibrium(const PatternEnergy &energy, const std::vector<double> &start, const double k)
  {
    const Minimum minimum = minimize(energy, start, 0.05, 1e-6);
    PatternShape shape = {minimum.place, energy.height(minimum.place, 0., 0.), 0., minimum.value};
    // The lowest place: of hexagons on the way between three crests, of ridges half a wave away.
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j <= 40; ++j)
        shape.trough = std::min(shape.trough,
                                energy.height(minimum.place,
                                              2. * pi / (std::sqrt(3.) * k) * i / 40.,
                                              2. * pi / k * j / 40.));
    return shape;
  }
} // namespace magmpm::verification
