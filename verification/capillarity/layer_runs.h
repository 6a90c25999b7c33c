#pragma once

#include <verification/capillarity/ferrofluid_layer.h>

/**
 * A layer of ferrofluid of magmpm in 2D, half a wave long, between mirrors (slip, shielded) at a crest and a trough, in
 * hydrostatic pressure at first. Linear law.
 */
namespace magmpm::verification
{
  struct LayerRun
  {
    FerrofluidLayer layer;        ///< its depth, height, floor and faces are those of the run
    double wave_number     = 1.;  ///< k [sqrt(rho g/gamma)]
    double magnetization   = 0.;  ///< M of the flat layer, over the critical one of the box
    int cells              = 32;  ///< of the lattice a wave length, a multiple of 8
    int depth_cells        = 16;  ///< a multiple of 4, as the next
    int height_cells       = 16;  ///< of the space above
    int particles_per_edge = 3;   ///< of a cell
    double sound           = 4.;  ///< sqrt(K/rho) [m/s]
    double steepness       = 0.1; ///< k times the amplitude that the start aims at
    double duration        = 0.;  ///< [s]; 0: as long as a measurement needs
    double damping         = 0.;  ///< Rest/Damping rate [1/s]

    double
    k() const; ///< [1/m]

    /** With its depth, height and faces. */
    FerrofluidLayer
    boxed_layer() const;

    /** Of the flat layer. */
    LayerField
    state() const;
  };

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
  };

  LayerSpikes
  layer_spikes(const LayerRun &run);
} // namespace magmpm::verification
