#pragma once

namespace magmpm::verification
{
  /**
   * A deep layer of magnetizable fluid of linear law in a vertical field, in 2D, between mirrors, with
   * a small standing wave on its surface, at rest at first. Its amplitude goes as cosh(s t) or
   * cos(omega t), where without viscosity and surface tension
   *   s^2 = -omega^2 = mu_0 M^2 k^2/(rho (1 + mu_0/mu)) - g k tanh(k d),
   * M the magnetization of the layer, d its depth (k d = pi here). Without gravity's help short waves
   * grow, those with k above k_c = rho g (1 + mu_0/mu)/(mu_0 M^2).
   */
  struct SurfaceWave
  {
    double over_cutoff      = 2.;  ///< k/k_c; 0: no field
    int cells_per_half_wave = 32;  ///< pi/(k dx)
    int particles_per_edge  = 4;   ///< of a cell
    double steepness        = 0.1; ///< k times the amplitude at the start
    double sound_ratio      = 40.; ///< speed of sound over sqrt(g/k)
    double duration         = 1.2; ///< |s| t at the end
  };

  /** What became of the wave. */
  struct SurfaceGrowth
  {
    double exact_square;    ///< s^2 [1/s^2]
    double measured_square; ///< the same, fitted to the amplitudes of the run
    double final_amplitude; ///< over that at the start
    double exact_amplitude; ///< the same by the formula
    double fit_error;       ///< rms of what the fit leaves, over the amplitude at the start
    double final_steepness; ///< k times the amplitude

    /** Of |s|; with the sign of measured less exact. Minus 1 where one grows and the other swings. */
    double
    relative_error() const;
  };

  /**
   * Runs the scene. The amplitude is that of the volume in columns,
   *   A = 2/lambda int (h(x) - d) cos(k x) dx = 2/lambda sum_p V_p cos(k x_p),
   * over the middle one of two wave lengths: disturbances from the walls do not reach it in time.
   */
  SurfaceGrowth
  surface_growth(const SurfaceWave &wave);
} // namespace magmpm::verification
