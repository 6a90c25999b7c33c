#pragma once

namespace magmpm::verification
{
  /** Fluid of even depth between two walls half a wave length apart. */
  struct WaveTank
  {
    double width   = 1.;   ///< pi/k [m]
    double depth   = 0.5;  ///< [m]
    double sound   = 20.;  ///< sqrt(K/rho) [m/s]
    double gravity = 9.81; ///< [m/s^2]
  };

  /**
   * Circular frequency of a standing wave [1/s], without viscosity and surface tension. A small one has
   * the potential Y(y) cos(k x) with
   *   Y'' - g/c^2 Y' - (k^2 - omega^2/c^2) Y = 0,  Y' = 0 at the floor,  g Y' = omega^2 Y at the surface,
   * which without compression is omega^2 = g k tanh(k d). One of the amplitude a is slower or faster by the
   * factor 1 + (k a)^2 w_2/(2 w_0), w_0^2 = tanh(k d), 32 w_2 = 9 w_0^-7 - 12 w_0^-3 - 3 w_0 - 2 w_0^5 (Tadjbakhsh
   * and Keller, J. Fluid Mech. 8, 1960).
   */
  double
  standing_wave_frequency(const WaveTank &tank, const double amplitude = 0.);

  /** A damped wave fitted to that of a run: a exp(-b t) cos(omega t + phase). */
  struct StandingWave
  {
    double frequency; ///< relative error of omega
    double decay;     ///< 1 - exp(-2 pi b/omega): the part of the amplitude lost in a period
    double misfit;    ///< rms of what the fit leaves, over the amplitude
    double amplitude; ///< at the start of the fit [m]
  };

  /**
   * A standing wave in 2D, two cells high (0 to crest), over six periods. It is raised from rest by gravity that
   * leans to either side for two periods, at the frequency of a small wave and as the square of a sine: so
   * every layer starts with its hydrostatic pressure. That raises 7 % of the wave of a third of the length as well,
   * to which the amplitude
   *   A = 2/width int (h - d) cos(k x) dx = 2/width sum_p V_p cos(k x_p)
   * is blind.
   *
   * @param cells  of the lattice along the width.
   */
  StandingWave
  standing_wave(const int cells);
} // namespace magmpm::verification
