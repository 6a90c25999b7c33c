#include "catch.h"

#include <magmpm/base/constants.h>
#include <magmpm/materials/critical_layer.h>

#include <cmath>

using namespace magmpm;

// With a linear law the critical magnetization is that of Cowley and Rosensweig's formula, mu_0 M_c^2 = 2 (1 +
// mu_0/mu) sqrt(rho g gamma), and the field M/chi; a critical wave of this fluid is 9.83 mm long.
TEST_CASE("A linear layer has the critical magnetization of Cowley and Rosensweig", "[materials]")
{
  const FerrofluidProperties fluid = {1020., 0.0245, 9.81, {0., 1.5}};
  const auto critical              = critical_layer(fluid, {MagnetizationLaw::linear});
  REQUIRE(critical.has_value());
  const double pressure = std::sqrt(1020. * 9.81 * 0.0245);
  CHECK(constants::vacuum_permeability * std::pow(critical->magnetization, 2) ==
        Approx(2. * (1. + 1. / 2.5) * pressure).epsilon(1e-12));
  CHECK(critical->field == Approx(critical->magnetization / 1.5).epsilon(1e-12));
  CHECK(2. * constants::pi * capillary_length(fluid) == Approx(9.83e-3).epsilon(1e-3));
}

// Langevin's law with a high saturation is the linear one, with a lower one it takes more field (here 15.8 mT),
// and with one below the critical magnetization no field does: M_s is all that there is of M.
TEST_CASE("A layer that saturates takes more field, or none does", "[materials]")
{
  FerrofluidProperties fluid = {1020., 0.0245, 9.81, {1e9, 1.}};
  const double linear        = critical_layer(fluid, {MagnetizationLaw::linear})->induction;
  CHECK(critical_layer(fluid, {MagnetizationLaw::langevin})->induction ==
        Approx(linear).epsilon(1e-6));
  fluid.content.saturation_magnetization = 24e3;
  CHECK(critical_layer(fluid, {MagnetizationLaw::langevin})->induction ==
        Approx(15.80e-3).epsilon(1e-3));
  fluid.content.saturation_magnetization = 3e3;
  CHECK(!critical_layer(fluid, {MagnetizationLaw::langevin}).has_value());
}
