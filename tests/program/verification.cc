#include "catch.h"

#include <verification/mechanics/cantilever.h>
#include <verification/mechanics/channel_flow.h>
#include <verification/mechanics/dam_break.h>
#include <verification/mechanics/elastic_bar.h>
#include <verification/mechanics/fluid_motion.h>
#include <verification/mechanics/free_beam.h>
#include <verification/mechanics/hydrostatic_column.h>
#include <verification/mechanics/spinning_block.h>
#include <verification/mechanics/stretched_bar.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

// The cases of benchmarks/mechanics_verification on their coarser lattices; doc/verification.md has
// the errors on finer ones and says where they come from.

TEST_CASE("An elastic bar swings at its frequency", "[program]")
{
  // A clamped bar that gravity pulls along: f = sqrt(E/rho)/(4 L). The clamp is where the wall is.
  const double coarse = frequency_error(16);
  const double fine   = frequency_error(32);
  INFO("relative errors " << coarse << " and " << fine);
  CHECK(std::abs(coarse) < 0.002);
  CHECK(std::abs(fine) < 0.6 * std::abs(coarse));
}

TEST_CASE("A strip of two cells sags as it should", "[program]")
{
  // The elastica of the same strip, which lies off the lattice; once it is at rest, it stays there.
  Cantilever cantilever;
  cantilever.dim                = 2;
  cantilever.offset             = 0.31;
  const CantileverErrors errors = cantilever_errors(cantilever);
  INFO("error of the sag " << errors.sag << ", change " << errors.change);
  CHECK(std::abs(errors.sag) < 0.03);
  CHECK(std::abs(errors.change) < 0.003);
}

TEST_CASE("A nearly incompressible strip of two cells sags as it should", "[program]")
{
  // The same with Poisson's ratio 0.49, against finite elements. Where each particle keeps its own volume the
  // strip is 5 % too stiff.
  Cantilever cantilever;
  cantilever.dim                = 2;
  cantilever.offset             = 0.31;
  cantilever.poisson_ratio      = 0.49;
  const CantileverErrors errors = cantilever_errors(cantilever);
  INFO("error of the sag " << errors.sag << ", change " << errors.change);
  CHECK(std::abs(errors.sag) < 0.03);
  CHECK(std::abs(errors.change) < 0.003);
}

TEST_CASE("A nearly incompressible bar stretched by half and let back gains nothing", "[program]")
{
  // Driven ends, no damping: the force is that of a bar with free sides at the same stretch, and the energy is
  // never more than the work. Where each particle keeps its own volume the pressure is twice as noisy.
  StretchedBar bar;
  bar.offset                 = 0.31;
  const StretchErrors errors = errors_of_stretching(bar);
  INFO("force " << errors.force << ", stress " << errors.stress << ", noise " << errors.noise);
  CHECK(std::abs(errors.force) < 0.02);
  CHECK(std::abs(errors.stress) < 0.02);
  CHECK(errors.noise < 0.08);
  CHECK(errors.gained < 1e-5);
  CHECK(errors.rise < 2e-3);
}

TEST_CASE("F and the shape of a bent beam agree", "[program]")
{
  // Couples bend a free beam of two cells into a V of which the elastica is known; its ends have turned as
  // far as F says. With the places moved by v instead of P v they turn 27 % too far.
  const VBeamErrors errors = v_beam_errors({}, 3., 2., 0.7);
  INFO("height " << errors.height << ", reach " << errors.reach << ", angle "
                 << errors.angle_of_ends);
  CHECK(std::abs(errors.height) < 0.01);
  CHECK(std::abs(errors.reach) < 0.01);
  CHECK(std::abs(errors.angle_of_ends) < 0.045);
}

TEST_CASE("What a transfer loses counts time, not steps", "[program]")
{
  // A bar in its first mode, with steps of 0.4 and 0.1 dx/c: with FMPM it loses the same in a period, below
  // 1 %; APIC three times as much with the shorter steps.
  const double coarse = loss_of_bar(Transfer::fmpm, 0.4), fine = loss_of_bar(Transfer::fmpm, 0.1);
  INFO("losses " << coarse << " and " << fine);
  CHECK(coarse < 0.01);
  CHECK(fine < 1.5 * coarse);
  CHECK(coarse < 1.5 * fine);
  CHECK(loss_of_bar(Transfer::apic, 0.1) > 2. * loss_of_bar(Transfer::apic, 0.4));
}

TEST_CASE("A fluid at rest has hydrostatic pressure", "[program]")
{
  // The pressure of every layer of one cell is the weight above it, also in the cell on the floor.
  const HydrostaticErrors errors = hydrostatic_errors(8);
  INFO("errors " << errors.inside << ", floor " << errors.floor_cell);
  CHECK(errors.inside < 0.005);
  CHECK(std::abs(errors.floor_cell) < 0.005);
}

TEST_CASE("A stirred pool with a block in it keeps its momentum", "[program]")
{
  // Fluid, an elastic block on the slippery floor and a free paddle: nothing pushes along the floor, so only rounding
  // changes the sum. Where nodes that the floor holds give nothing back along it, FMPM of the block loses 7e-4.
  CHECK(momentum_change_of_stirred_pool() < 1e-11);
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
  // Six turns of an elastic block that vibrates: with APIC angular momentum changes by rounding only. With
  // FMPM, ten turns of one whose edge moves at a twentieth of the speed of sound, by less than 1e-4.
  CHECK(angular_momentum_error(4) < 1e-10);
  CHECK(change_of_angular_momentum<2>(Transfer::fmpm) < 1e-4);
}
