#include "catch.h"

#include <verification/capillarity/drop_runs.h>
#include <verification/capillarity/layer_runs.h>
#include <verification/capillarity/noise_growth.h>
#include <verification/capillarity/sessile_drop.h>

#include <cmath>

using namespace magmpm;
using namespace magmpm::verification;

// Limits of surface tension that are missed, each beside a guard of what is reached. Whoever mends one is told so by its
// test. doc/verification.md has the figures, of causes none is known.

namespace
{
  /** The velocities of a drop of 16 dx and next to no viscosity, over the later half of 2 R/U. */
  RestingDrop
  fine_drop()
  {
    static const RestingDrop drop = [] {
      DropRun run;
      run.cells    = 16;
      run.duration = 2.;
      return resting_drop(run);
    }();
    return drop;
  }

  SessileDrop
  flat_drop()
  {
    static const SessileDrop drop = [] {
      SessileRun run;
      run.angle = 30.;
      return sessile_drop(run);
    }();
    return drop;
  }

  SessileDrop
  small_drop()
  {
    static const SessileDrop drop = [] {
      SessileRun run;
      run.dim                = 3;
      run.cells              = 6;
      run.particles_per_edge = 2;
      return sessile_drop(run);
    }();
    return drop;
  }

  NoiseGrowth
  wave_of_noise()
  {
    static const NoiseGrowth growth = [] {
      LayerRun run;
      run.magnetization   = 1.1;
      run.cells           = 24;
      run.depth_cells     = 12;
      run.height_cells    = 12;
      run.jitter          = 0.5;
      run.layer.viscosity = 4e-6;
      run.waves           = 5.;
      return noise_growth(run);
    }();
    return growth;
  }

  LayerGrowth
  short_wave()
  {
    static const LayerGrowth growth = [] {
      LayerRun run;
      run.magnetization   = 1.3;
      run.wave_number     = 2.;
      run.steepness       = 0.2;
      run.layer.viscosity = 1e-6;
      return layer_growth(run);
    }();
    return growth;
  }

  LayerSpikes
  tall_spikes()
  {
    static const LayerSpikes spikes = [] {
      LayerRun run;
      run.magnetization      = 1.1;
      run.cells              = 24;
      run.depth_cells        = 12;
      run.height_cells       = 36;
      run.particles_per_edge = 4;
      run.layer.viscosity    = 4e-6;
      run.damping            = 20.;
      run.duration           = 0.4;
      run.steepness          = 0.2;
      return layer_spikes(run);
    }();
    return spikes;
  }
} // namespace

TEST_CASE("What is missed of surface tension is not missed by more", "[program]")
{
  // Guards, of the runs of the tests below: half as much again as was measured, or as many particles.
  CHECK(fine_drop().rms < 0.035);
  CHECK(std::abs(flat_drop().angle - 30.) < 3.);
  CHECK(flat_drop().n_lost < 30);
  CHECK(std::abs(small_drop().angle - 60.) < 8.);
  CHECK(std::abs(wave_of_noise().wave_number / wave_of_noise().exact - 1.) < 0.15);
  CHECK(std::abs(short_wave().error()) < 0.08);
  CHECK(tall_spikes().n_flying < 20.);
}

TEST_CASE("A drop of 16 cells and little viscosity rests", "[program][!shouldfail]")
{
  // Its particles move by less than 1 % of U, as those of one of 8 cells nearly do.
  CHECK(fine_drop().rms < 0.01);
}

TEST_CASE("No particle runs away from a contact line of 30 degrees", "[program][!shouldfail]")
{
  // Nothing holds one that is alone on a wall, but nothing should pull it out either.
  CHECK(flat_drop().n_lost == 0);
}

TEST_CASE("A drop of 6 cells in 3D meets a wall at 60 degrees", "[program][!shouldfail]")
{
  // To 5 degrees, by the moments of a spherical cap.
  CHECK(std::abs(small_drop().angle - 60.) < 5.);
}

TEST_CASE("The wave that grows fastest comes out of the noise", "[program][!shouldfail]")
{
  // Within 10 %, as the mean wave number of those that grow, of a viscous layer of its depth.
  CHECK(std::abs(wave_of_noise().wave_number / wave_of_noise().exact - 1.) < 0.1);
}

TEST_CASE("Short waves on ferrofluid grow as fast as they must", "[program][!shouldfail]")
{
  // Of half the critical length, 32 cells a wave, at 1.3 M_c: by their rate to 5 %.
  CHECK(std::abs(short_wave().error()) < 0.05);
}

TEST_CASE("No particle leaves the tips of spikes", "[program][!shouldfail]")
{
  // The crest is where least energy has it, so what is 1 mm above has been thrown there.
  CHECK(tall_spikes().n_flying == 0.);
}

TEST_CASE("A drop meets a face on nodes of the lattice at the angle asked for",
          "[program][!shouldfail]")
{
  // A rigid slab whose face lies in a plane of nodes, 120 degrees as between nodes to 6: it comes to 137. The contact of
  // fluids does not hold nodes on a face or in front of it; whether that is the cause is not shown.
  SessileRun run;
  run.angle = 120.;
  run.slab  = 8.;
  run.cells = 8;
  CHECK(std::abs(sessile_drop(run).angle - run.angle) < 6.);
}
