#pragma once

#include <verification/capillarity/ferrofluid_layer.h>

#include <vector>

namespace magmpm::verification
{
  /**
   * A cell of the hexagonal pattern of magmpm, two crests on opposite corners between mirrors (slip, shielded), damped
   * until it rests. Its edges are in the ratio 16 to 28, 1 % less than 1 to sqrt(3); lambda is that of its area.
   */
  struct HexagonRun
  {
    FerrofluidLayer layer;    ///< its depth, height, floor and faces are those of the run
    double wave_number = 1.;  ///< k [sqrt(rho g/gamma)]
    double induction   = 1.1; ///< B, over the critical one of the box
    double start = 0.8; ///< height of the pattern at the start, over that of least energy; 0: flat
    int cells    = 28;  ///< of the lattice along the longer edge, a multiple of 28
    double sound = 4.;  ///< sqrt(K/rho) [m/s]
    double damping  = 20.;  ///< Rest/Damping rate [1/s]
    double duration = 0.25; ///< [s]

    double
    k() const; ///< [1/m]

    /** Half a cell edge deep, a ceiling one and a half above. */
    FerrofluidLayer
    boxed_layer() const;

    LayerField
    state() const;
  };

  /** Amplitudes of the first mode, cos(k y) and its turned ones, which is a_1 at a crest; of the later half of the run. */
  struct HexagonHeights
  {
    double first_mode; ///< mean a_1 [m]
    double exact;      ///< of least energy, 0 if none stands [m]
    double crest;      ///< exact height of a crest [m]
    double change;     ///< largest less least a_1 of the last fifth [m]
    double highest;    ///< particle over the flat surface, in the later half [m]
  };

  HexagonHeights
  hexagon_heights(const HexagonRun &run);
} // namespace magmpm::verification
