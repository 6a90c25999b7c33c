#include "catch.h"

#include <magmpm/base/constants.h>

#include <verification/capillarity/spike_equilibrium.h>
#include <verification/capillarity/surface_waves.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  /** chi = 1, half a wave length deep, the ceiling one and a half above the surface. */
  FerrofluidLayer
  shielded_layer()
  {
    FerrofluidLayer layer;
    const double wave_length = 2. * constants::pi / layer.capillary_wave_number();
    layer.depth              = 0.5 * wave_length;
    layer.height             = 1.5 * wave_length;
    layer.faces              = FieldFaces::shielded;
    return layer;
  }

  /** M_c of a deep layer. */
  double
  critical_magnetization()
  {
    return critical_state(FerrofluidLayer()).state.magnetization;
  }
} // namespace

TEST_CASE("The energy of spikes is that of small waves and knows its slope", "[verification]")
{
  // A wave a cos(k x) costs G a^2/4 per length, G the stiffness of linear theory, up to a^4; n-th modes likewise. The
  // derivatives are those of differences at a surface as steep as spikes are.
  const FerrofluidLayer layer = shielded_layer();
  const double k              = layer.capillary_wave_number();
  for (const double m : {0.5, 1.1})
    {
      const LayerField state = field_of_magnetization(layer, m * critical_magnetization());
      const SpikeEnergy energy(layer, state, k);
      for (const int n : {1, 2})
        {
          constexpr double a = 2e-3;
          std::vector<double> modes(n, 0.);
          modes.back()       = a;
          const double exact = 0.25 * stiffness(layer, state, n * k) * a * a / (k * k);
          CHECK(energy(modes).value * layer.surface_tension == Approx(exact).epsilon(1e-3));
        }
      const std::vector<double> steep = {1.4, 0.3, 0.1};
      const ValueAndGradient there    = energy(steep);
      for (int n = 0; n < 3; ++n)
        {
          std::vector<double> more = steep, less = steep;
          more[n] += 1e-4;
          less[n] -= 1e-4;
          CHECK(there.gradient[n] ==
                Approx((energy(more).value - energy(less).value) / 2e-4).epsilon(1e-5));
        }
    }
}

TEST_CASE("Spikes have the height of least energy", "[verification]")
{
  // None below the critical field. Above it a_1 goes as the root of what M is above it, and 4 or 8 modes give it to 0.1 %. At
  // 1.05, 1.1 and 1.2 M_c bilinear elements on 24 columns had 1.034, 1.483 and 2.211 mm, twice finer ones 1.043, 1.491
  // and 2.220: their limits are 1.046, 1.494 and 2.223.
  const FerrofluidLayer layer = shielded_layer();
  const double k              = layer.capillary_wave_number(),
               critical       = critical_state(layer).state.magnetization;
  const auto first_mode       = [&](const double magnetization, const int n_modes = 6) {
    return spike_equilibrium(layer, field_of_magnetization(layer, magnetization), k, n_modes)
      .modes[0];
  };
  CHECK(std::abs(first_mode(0.97 * critical)) < 1e-6);
  CHECK(first_mode(1.004 * critical) / first_mode(1.001 * critical) == Approx(2.).epsilon(0.02));
  for (const auto &[m, height] : {std::pair{1.05, 1.046e-3}, {1.1, 1.494e-3}, {1.2, 2.223e-3}})
    {
      const double now = first_mode(m * critical_magnetization());
      CHECK(now == Approx(height).epsilon(2e-3));
      CHECK(first_mode(m * critical_magnetization(), 4) == Approx(now).epsilon(1e-3));
      CHECK(first_mode(m * critical_magnetization(), 8) == Approx(now).epsilon(1e-3));
    }
}
