#pragma once

#include <verification/capillarity/layer_scene.h>

/** What becomes of the surface of a layer of ferrofluid of magmpm, half a wave long. */
namespace magmpm::verification
{
  /** A standing wave that leaning gravity has raised for two periods: four more of them. */
  struct LayerWave
  {
    double frequency; ///< over that of the viscous wave, less 1
    double decay;     ///< part of the amplitude lost in a period
    double exact_decay;
    double misfit;    ///< over the amplitude
    double steepness; ///< k a at the start of the fit
  };

  LayerWave
  layer_wave(const LayerRun &run);

  /** A wave of the flat layer, pushed by gravity that leans for a moment, until it has the steepness. */
  struct LayerGrowth
  {
    /** s^2 of a cosh(s t) + b sinh(s t), or -omega^2 of a damped wave; measured and of the viscous wave [1/s^2]. */
    double rate_square, exact;
    double misfit;    ///< over the largest amplitude
    double steepness; ///< largest k a
    double
      late_over_early; ///< largest amplitude of the last third of the run over that of the first

    /** |s| or omega, over the exact one, less 1; -1 where one grows and the other does not. */
    double
    error() const;
  };

  LayerGrowth
  layer_growth(const LayerRun &run);

  /** Spikes from a flat layer that was pushed: the later half of the run. */
  struct LayerSpikes
  {
    double first_mode; ///< mean a_1 [m]
    double exact;      ///< of least energy [m]
    double change;     ///< largest less least a_1 of the last fifth, over the mean
    double crest;      ///< exact height of the crest [m]
    double highest;    ///< particle over the flat surface, in the whole run [m]
    double
      n_flying; ///< most particles at once that are 1 mm and more above the crest, of the whole run
  };

  LayerSpikes
  layer_spikes(const LayerRun &run);
} // namespace magmpm::verification
