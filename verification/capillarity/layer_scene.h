#pragma once

#include <verification/capillarity/ferrofluid_layer.h>
#include <verification/program/particle_frame.h>

#include <string>

namespace magmpm::verification
{
  /**
   * A layer of ferrofluid of magmpm in 2D between mirrors (slip, shielded), half a wave long if not said otherwise, in
   * hydrostatic pressure at first. Linear law.
   */
  struct LayerRun
  {
    FerrofluidLayer layer;       ///< its depth, height, floor and faces are those of the run
    double wave_number     = 1.; ///< k [sqrt(rho g/gamma)]
    double magnetization   = 0.; ///< M of the flat layer, over the critical one of the box
    int cells              = 32; ///< of the lattice a wave length, a multiple of 8
    int depth_cells        = 16; ///< a multiple of 4, as the next
    int height_cells       = 16; ///< of the space above
    int particles_per_edge = 3;  ///< of a cell
    double waves =
      0.5; ///< width of the box over the wave length; n and a half: crest and trough at its ends
    double jitter    = 0.;  ///< of the particles, of their spacing
    double sound     = 4.;  ///< sqrt(K/rho) [m/s]
    double steepness = 0.1; ///< k times the amplitude that the start aims at
    double duration  = 0.;  ///< [s]; 0: as long as a measurement needs
    double damping   = 0.;  ///< Rest/Damping rate [1/s]

    double
    k() const; ///< [1/m]

    /** With its depth, height and faces. */
    FerrofluidLayer
    boxed_layer() const;

    /** Of the flat layer. */
    LayerField
    state() const;
  };

  /**
   * The parameter file, without output directory.
   *
   * @param lean  gravity along x, an expression of t [m/s^2].
   * @param end   [s]
   */
  std::string
  layer_scene(const LayerRun &run, const std::string &lean, const double end, const int n_frames);

  /** 2/width int (h - d) cos(k x) dx = 2/width sum_p V_p cos(k x_p) [m]. @param k  a multiple of pi/width [1/m]. */
  double
  mode_amplitude(const LayerRun &run, const ParticleFrame &frame, const double k);
} // namespace magmpm::verification
