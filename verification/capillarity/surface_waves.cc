#include <magmpm/base/constants.h>

#include <verification/capillarity/complex_zero.h>
#include <verification/capillarity/extremum.h>
#include <verification/capillarity/surface_waves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace magmpm::verification
{
  namespace
  {
    constexpr double mu0 = constants::vacuum_permeability;

    using Complex = std::complex<double>;
    using Row     = std::array<Complex, 4>;

    /** By elimination with the largest pivot of each column. */
    Complex
    determinant(std::array<Row, 4> rows)
    {
      Complex product = 1.;
      for (int c = 0; c < 4; ++c)
        {
          const auto pivot =
            std::max_element(rows.begin() + c, rows.end(), [c](const Row &a, const Row &b) {
              return std::abs(a[c]) < std::abs(b[c]);
            });
          if (pivot != rows.begin() + c)
            {
              std::swap(*pivot, rows[c]);
              product = -product;
            }
          product *= rows[c][c];
          for (int r = c + 1; r < 4; ++r)
            {
              const Complex factor = rows[r][c] / rows[c][c];
              for (int j = c; j < 4; ++j)
                rows[r][j] -= factor * rows[c][j];
            }
        }
      return product;
    }

    /** A deep layer is one of ten times 1/k: what is below moves by exp(-10). */
    double
    depth_of(const FerrofluidLayer &layer, const double k)
    {
      return std::min(layer.depth, 20. / k);
    }

    /**
     * Zero where exp(s t) is a motion. Unknown are the shares of exp(k z), exp(-k (z + d)), exp(m z), exp(-m (z + d))
     * in the vertical velocity w; the first two alone have a pressure, -rho s/k^2 dw/dz. Equations: w = 0 and dw/dz =
     * 0 (stick) or w'' = 0 (slip) at the floor; no shear, w'' + k^2 w = 0, and s (p - 2 nu rho dw/dz) = G w at the surface.
     */
    Complex
    mismatch(const FerrofluidLayer &layer,
             const double stiffness,
             const double k,
             const double viscosity,
             const Complex rate)
    {
      const double depth = depth_of(layer, k);
      const Complex m    = std::sqrt(k * k + rate / viscosity);
      std::array<Row, 4> rows;
      const Complex exponents[4] = {k, -k, m, -m};
      for (int i = 0; i < 4; ++i)
        {
          const Complex e        = exponents[i];
          const bool is_from_top = i % 2 == 0;
          const Complex across   = std::exp(-(is_from_top ? e : -e) * depth);
          const Complex at_floor = is_from_top ? across : 1., at_top = is_from_top ? 1. : across;
          const Complex pressure = i < 2 ? -layer.density * rate / (k * k) * e : 0.;
          rows[0][i]             = at_floor;
          rows[1][i] = (layer.floor == Floor::slip ? e * e / (k * k) : e / k) * at_floor;
          rows[2][i] = (e * e / (k * k) + 1.) * at_top;
          rows[3][i] = (rate * (pressure - 2. * viscosity * layer.density * e) / stiffness - 1.) *
                       at_top;
        }
      // exp(k z) and exp(m z) are the same at s = 0, which is no motion.
      return determinant(rows) / (rate / viscosity) * k * k;
    }

    /** The first real zero on the way from @p first to @p last; 0 if there is none. */
    double
    first_zero(const FerrofluidLayer &layer,
               const double stiffness,
               const double k,
               const double first,
               const double last)
    {
      const auto f = [&](const double rate) {
        return mismatch(layer, stiffness, k, layer.viscosity, rate).real();
      };
      constexpr int n_steps = 200;
      double before = first, after = first;
      const double at_first = f(first);
      for (int i = 1; i <= n_steps && f(after) * at_first > 0.; ++i)
        {
          before = after;
          after  = first * std::pow(last / first, static_cast<double>(i) / n_steps);
        }
      if (f(after) * at_first > 0.)
        return 0.;
      for (int i = 0; i < 60; ++i)
        {
          const double middle                          = 0.5 * (before + after);
          (f(middle) * at_first > 0. ? before : after) = middle;
        }
      return 0.5 * (before + after);
    }

    /** Viscosity is raised from next to nothing, and the rate followed. @param free  without viscosity. */
    Complex
    swinging(const FerrofluidLayer &layer,
             const double stiffness,
             const double k,
             const Complex free)
    {
      const double first = std::min(1e-4 * std::abs(free) / (k * k), layer.viscosity);
      const int n_steps  = 1 + static_cast<int>(20. * std::log(layer.viscosity / first));
      Complex rate       = free;
      for (int i = 0; i <= n_steps; ++i)
        {
          const double viscosity = first * std::pow(layer.viscosity / first,
                                                    static_cast<double>(i) / n_steps);
          rate                   = complex_zero(
            [&](const Complex s) { return mismatch(layer, stiffness, k, viscosity, s); }, rate);
        }
      return rate;
    }
  } // namespace

  double
  stiffness(const FerrofluidLayer &layer, const LayerField &state, const double k)
  {
    const double fall = layer.density * layer.gravity + layer.surface_tension * k * k;
    if (state.magnetization == 0.)
      return fall;
    const double along = 1. + state.slope, across = 1. + state.magnetization / state.field;
    const double r = std::sqrt(along * across);
    double inside = std::tanh(k * r / along * layer.depth), outside = std::tanh(k * layer.height);
    if (layer.faces == FieldFaces::open)
      {
        inside  = (inside + 1. / r) / (1. + inside / r);
        outside = 1.;
      }
    const double m = state.magnetization;
    return fall - mu0 * m * m * k / (1. / (r * inside) + 1. / outside);
  }

  double
  inviscid_rate_square(const FerrofluidLayer &layer, const LayerField &state, const double k)
  {
    return -stiffness(layer, state, k) * k * std::tanh(k * layer.depth) / layer.density;
  }

  Complex
  wave_rate(const FerrofluidLayer &layer, const LayerField &state, const double k)
  {
    const double square = inviscid_rate_square(layer, state, k), g = stiffness(layer, state, k);
    const Complex free = std::sqrt(Complex(square, 0.));
    if (layer.viscosity == 0.)
      return free;
    if (g < 0.)
      return first_zero(layer, g, k, 1e-9 * free.real(), free.real());
    // Without inertia it creeps back this fast, less in a film; a wave that swings has no zero before m = 0.
    const double creep = 0.5 * square / (layer.viscosity * k * k);
    const double last  = -0.999 * layer.viscosity * k * k;
    const double slow  = 1e-6 * creep > last ? first_zero(layer, g, k, 1e-6 * creep, last) : 0.;
    return slow < 0. ? slow : swinging(layer, g, k, free);
  }

  CriticalState
  critical_state(const FerrofluidLayer &layer)
  {
    const double middle = layer.capillary_wave_number();
    const auto softest  = [&](const LayerField &state) {
      return place_of_minimum(
        [&](const double k) { return stiffness(layer, state, k); }, 0.05 * middle, 5. * middle);
    };
    double below = 0., above = 1.;
    const auto grows = [&](const double field) {
      const LayerField state = layer_field(layer, field);
      return stiffness(layer, state, softest(state)) < 0.;
    };
    while (!grows(above))
      above *= 2.;
    for (int i = 0; i < 60; ++i)
      {
        const double field             = 0.5 * (below + above);
        (grows(field) ? above : below) = field;
      }
    const LayerField state = layer_field(layer, above);
    return {state, softest(state)};
  }

  FastestWave
  fastest_wave(const FerrofluidLayer &layer, const LayerField &state)
  {
    const double middle  = layer.capillary_wave_number();
    const double softest = place_of_minimum(
      [&](const double k) { return stiffness(layer, state, k); }, 0.05 * middle, 20. * middle);
    const double k =
      place_of_minimum([&](const double wave) { return -wave_rate(layer, state, wave).real(); },
                       0.5 * std::min(softest, middle),
                       1.5 * softest);
    return {k, wave_rate(layer, state, k).real()};
  }
} // namespace magmpm::verification
