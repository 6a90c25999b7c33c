#pragma once

#include <verification/capillarity/layer_scene.h>

namespace magmpm::verification
{
  /** Which wave has grown out of the noise of particles that were laid with jitter. */
  struct NoiseGrowth
  {
    double
      wave_number; ///< mean over the squares of the amplitudes of the modes of the box that grow [1/m]
    double exact;     ///< of the wave that grows fastest, with depth and viscosity [1/m]
    double steepness; ///< k times sqrt(2) times the rms height, where that was measured
    double time;      ///< of that frame [s]
  };

  /**
   * A flat layer above the critical field, several waves wide, until the steepness is 0.2 or the run ends.
   *
   * @param run  the wave number is set to that of the wave that grows fastest.
   */
  NoiseGrowth
  noise_growth(LayerRun run);
} // namespace magmpm::verification
