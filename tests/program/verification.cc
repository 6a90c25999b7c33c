#include "catch.h"

#include <verification/mechanics/channel_flow.h>
#include <verification/mechanics/dam_break.h>
#include <verification/mechanics/elastic_bar.h>
#include <verification/mechanics/hydrostatic_column.h>
#include <verification/mechanics/spinning_block.h>

#include <cmath>

using namespace magmpm::verification;

// The cases of benchmarks/mechanics_verification on their coarser lattices; doc/verification.md has
// the errors on finer ones and says where they come from.

TEST_CASE("An elastic bar swings at its frequency", "[program]")
{
  // A clamped bar that gravity pulls along: f = sqrt(E/rho)/(4 L). The clamped end is 0.2 dx off, so
  // the error halves with dx.
  const double coarse = frequency_error(16);
  const double fine   = frequency_error(32);
  INFO("relative errors " << coarse << " and " << fine);
  CHECK(std::abs(coarse) < 0.02);
  CHECK(std::abs(fine) < 0.6 * std::abs(coarse));
}

TEST_CASE("A fluid at rest has hydrostatic pressure", "[program]")
{
  // The pressure of every layer of one cell is the weight above it, to 5 % of the largest; in the cell
  // on the floor, whose B-splines the floor cuts, to 12 %.
  const HydrostaticErrors errors = hydrostatic_errors(8);
  INFO("errors " << errors.inside << ", floor " << errors.floor_cell);
  CHECK(errors.inside < 0.05);
  CHECK(std::abs(errors.floor_cell) < 0.12);
}

TEST_CASE("A collapsing column of water runs as measured", "[program]")
{
  // The front against the experiment of Martin and Moyce, 1952, n^2 = 2, until it has gone 4 a.
  const std::vector<DamFront> fronts = dam_fronts(8);
  REQUIRE(fronts.size() == 6);
  INFO("largest error " << dam_front_error(fronts));
  CHECK(dam_front_error(fronts) < 0.12);
}

TEST_CASE("Viscous flows have their profiles", "[program]")
{
  // Steady flows between walls, of the largest velocity: Couette's is linear and nearly exact on any
  // lattice; Poiseuille's has the error of where the wall is felt.
  CHECK(velocity_error(ChannelFlow::couette, 8) < 0.01);
  CHECK(velocity_error(ChannelFlow::poiseuille, 16) < 0.03);
}

TEST_CASE("The spin of a free block is kept", "[program]")
{
  // Six turns of an elastic block that vibrates: angular momentum changes by rounding only.
  CHECK(angular_momentum_error(4) < 1e-10);
}
