#include "catch.h"

#include <verification/capillarity/drop_runs.h>
#include <verification/capillarity/layer_runs.h>
#include <verification/capillarity/magnetic_drop_run.h>
#include <verification/capillarity/magnetic_drop_shape.h>
#include <verification/capillarity/sessile_drop.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

// Coarse cases of benchmarks/surface_tension and benchmarks/spikes, which say more of them.

TEST_CASE("A drop swings at its frequency", "[program]")
{
  // A viscous drop of 8 cells in its lowest mode, by the whole equation; no momentum comes from the surface.
  DropRun run;
  run.amplitude               = 0.05;
  const OscillatingDrop swing = oscillating_drop(run);
  INFO("omega " << swing.frequency << ", damping " << swing.damping);
  CHECK(std::abs(swing.frequency) < 0.015);
  CHECK(std::abs(swing.damping) < 0.1);
  CHECK(swing.momentum < 1e-12);
}

TEST_CASE("A drop that flies is a drop at rest", "[program]")
{
  // Its pressure is that of Young and Laplace to 3 %, as at rest, and it neither slows down nor changes its shape.
  DropRun run;
  run.velocity          = 0.5;
  const MovedDrop moved = moved_drop(run);
  INFO("pressure " << moved.drop.pressure << ", rms " << moved.drop.rms);
  CHECK(std::abs(moved.drop.pressure) < 0.03);
  CHECK(moved.drop.rms < 0.01);
  CHECK(std::abs(moved.speed) < 1e-3);
  CHECK(std::abs(moved.aspect) < 0.005);
}

TEST_CASE("A drop meets a wall at the angle asked for", "[program]")
{
  // Half a disc spreads or draws together until its moments are those of a cap of 60 or 120 degrees, to 3 degrees.
  for (const double angle : {60., 120.})
    {
      SessileRun run;
      run.angle              = angle;
      run.cells              = 8;
      const SessileDrop drop = sessile_drop(run);
      CHECK(std::abs(drop.angle - angle) < 3.);
    }
}

TEST_CASE("A drop meets a rigid body at the angle asked for", "[program]")
{
  // The same on a slab whose surface lies between nodes of the lattice, to 6 degrees; as a wall of its own it would
  // repel what has no angle given, which is 90 degrees.
  for (const double angle : {60., 90., 120.})
    {
      SessileRun run;
      run.angle              = angle;
      run.slab               = 3.37;
      run.cells              = 8;
      const SessileDrop drop = sessile_drop(run);
      INFO(angle << ": " << drop.angle);
      CHECK(std::abs(drop.angle - angle) < 6.);
    }
}

TEST_CASE("Waves on ferrofluid with surface tension grow as fast as they must", "[program]")
{
  // At 1.3 M_c the critical wave grows by its rate to 5 %; at 0.9 M_c it swings.
  LayerRun run;
  run.layer.viscosity      = 1e-6;
  run.steepness            = 0.2;
  run.magnetization        = 1.3;
  const LayerGrowth growth = layer_growth(run);
  CHECK(std::abs(growth.error()) < 0.05);
  run.magnetization = 0.9;
  CHECK(std::abs(layer_growth(run).error()) < 0.05);
}

TEST_CASE("Spikes stand as high as their energy says", "[program]")
{
  // The first mode of a layer in 2D at 1.1 M_c, damped to rest, is that of the minimum of the energy to 4 %.
  LayerRun run;
  run.magnetization        = 1.1;
  run.cells                = 24;
  run.depth_cells          = 12;
  run.height_cells         = 36;
  run.particles_per_edge   = 4;
  run.layer.viscosity      = 4e-6;
  run.damping              = 20.;
  run.duration             = 0.3;
  run.steepness            = 0.2;
  const LayerSpikes spikes = layer_spikes(run);
  INFO("a_1 " << spikes.first_mode << " m, exact " << spikes.exact << " m");
  CHECK(spikes.first_mode == Approx(spikes.exact).epsilon(0.04));
  CHECK(spikes.change < 0.05);
}

TEST_CASE("The tips of low spikes do not spray", "[program]")
{
  // At 1.05 M_c no particle rises 1 mm above the crest of least energy: where material is thin its heaviest nodes alone
  // take the magnetic force. With light ones too some rise by 2.3 mm.
  LayerRun run;
  run.magnetization        = 1.05;
  run.cells                = 24;
  run.depth_cells          = 12;
  run.height_cells         = 36;
  run.particles_per_edge   = 4;
  run.layer.viscosity      = 4e-6;
  run.damping              = 20.;
  run.duration             = 0.4;
  run.steepness            = 0.2;
  const LayerSpikes spikes = layer_spikes(run);
  CHECK(spikes.first_mode == Approx(spikes.exact).epsilon(0.04));
  CHECK(spikes.highest - spikes.crest < 1e-3);
}

TEST_CASE("A field stretches a drop as far as it costs energy", "[program]")
{
  // A disc of 8 cells, chi = 1, in the field in which an ellipse of 1.5 has the least energy, against the free shape.
  MagneticDropRun run;
  run.drop              = {2, 1.};
  run.bond_number       = bond_number_of_aspect(run.drop, 1.5);
  const double measured = magnetic_drop_aspect(run).measured;
  CHECK(measured ==
        Approx(magnetic_drop_shape(run.drop, run.bond_number).moment_aspect).epsilon(0.03));
}
