#include "catch.h"

#include <magmpm/base/constants.h>

#include <verification/capillarity/pattern_equilibrium.h>
#include <verification/capillarity/spike_equilibrium.h>
#include <verification/capillarity/surface_waves.h>

#include <cmath>
#include <vector>

using namespace magmpm;
using namespace magmpm::verification;

namespace
{
  FerrofluidLayer
  shielded_layer(const MagnetizationLaw law, const double susceptibility)
  {
    FerrofluidLayer layer;
    layer.law                = law;
    layer.medium             = {24e3, susceptibility};
    const double wave_length = 2. * constants::pi / layer.capillary_wave_number();
    layer.depth              = 0.5 * wave_length;
    layer.height             = 1.5 * wave_length;
    layer.faces              = FieldFaces::shielded;
    return layer;
  }

  /** In a field over the critical one. */
  LayerField
  state_of(const FerrofluidLayer &layer, const double over_critical)
  {
    return field_of_induction(layer, over_critical * critical_state(layer).state.induction());
  }
} // namespace

TEST_CASE("Ridges cost the same by a scalar as by a vector potential", "[verification]")
{
  // The energy of 2D spikes has been found with curl A, at fixed flux; here it is that of a potential whose gradient is
  // h. Both are the same where they are exact, to 2e-4 of it, slopes likewise.
  const FerrofluidLayer layer = shielded_layer(MagnetizationLaw::linear, 1.);
  const double k              = layer.capillary_wave_number();
  const LayerField state      = state_of(layer, 1.1);
  const PatternEnergy scalar(layer, state, k, Pattern::ridges, 3, 24);
  const SpikeEnergy vector(layer, state, k);
  const std::vector<double> modes = {0.5, 0.1, 0.03};
  const ValueAndGradient a = scalar(modes), b = vector(modes);
  CHECK(a.value == Approx(b.value).epsilon(2e-4));
  for (int n = 0; n < 3; ++n)
    CHECK(a.gradient[n] == Approx(b.gradient[n]).margin(1e-4));
}

TEST_CASE("The energy of hexagons is that of small waves and knows its slope", "[verification]")
{
  // A small pattern of crest a costs G a^2/12 per area, as the mean of its square is a^2/6; what goes with a^3 cancels in
  // the mean of a crest and a hole. The derivatives are those of differences at a tall pattern, with both laws.
  for (const MagnetizationLaw law : {MagnetizationLaw::linear, MagnetizationLaw::langevin})
    {
      const FerrofluidLayer layer = shielded_layer(law, 1.);
      const double k              = layer.capillary_wave_number();
      const LayerField state      = state_of(layer, 1.05);
      const PatternEnergy energy(layer, state, k, Pattern::hexagons, 3, 10);
      constexpr double a = 0.01;
      const double mean  = 0.5 * (energy({a, 0., 0.}).value + energy({-a, 0., 0.}).value);
      CHECK(mean * layer.surface_tension ==
            Approx(stiffness(layer, state, k) * a * a / (12. * k * k)).epsilon(0.01));
      const std::vector<double> tall = {1., 0.2, 0.1};
      const ValueAndGradient there   = energy(tall);
      for (int n = 0; n < 3; ++n)
        {
          std::vector<double> more = tall, less = tall;
          more[n] += 1e-4;
          less[n] -= 1e-4;
          CHECK(there.gradient[n] ==
                Approx((energy(more).value - energy(less).value) / 2e-4).epsilon(1e-3));
        }
    }
}

TEST_CASE("Hexagons stand below the critical field and ridges do not", "[verification]")
{
  // Waves of a hexagon drive each other, so that the pattern is there at once (Gailitis, J. Fluid Mech. 82, 1977): at 0.99
  // B_c it costs less than the flat layer, which is stable too; at 0.96 it falls. Ridges rise from nothing at B_c, where
  // hexagons cost less than they.
  const FerrofluidLayer layer = shielded_layer(MagnetizationLaw::linear, 1.);
  const double k              = layer.capillary_wave_number();
  const auto settle           = [&](const double field, const Pattern pattern, const double start) {
    const PatternEnergy energy(layer, state_of(layer, field), k, pattern, 4, 10);
    return pattern_equilibrium(energy, {start, 0.15 * start, 0.08 * start, 0.}, k);
  };
  const PatternShape tall = settle(0.99, Pattern::hexagons, 0.9);
  CHECK(tall.crest > 1e-3);
  CHECK(tall.crest > 2. * std::abs(tall.trough));
  CHECK(tall.energy < 0.);
  CHECK(settle(0.99, Pattern::hexagons, 0.05).crest < 1e-5);
  CHECK(settle(0.96, Pattern::hexagons, 0.9).crest < 1e-5);
  CHECK(settle(0.99, Pattern::ridges, 0.9).crest < 1e-5);
  CHECK(settle(1.05, Pattern::hexagons, 1.5).energy < settle(1.05, Pattern::ridges, 0.7).energy);
}
