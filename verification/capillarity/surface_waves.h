#pragma once

#include <verification/capillarity/ferrofluid_layer.h>

#include <complex>

/**
 * Small waves exp(s t) cos(k x) on a layer of magnetizable fluid, of which the surface has tension: Cowley and
 * Rosensweig, J. Fluid Mech. 30 (1967), here with the depth of the layer and the viscosity of the fluid.
 */
namespace magmpm::verification
{
  /**
   * What drives a wave back, pressure over height [Pa/m]:
   *   G = rho g + gamma k^2 - mu_0 M^2 k/(1/(r t) + 1/t'),  r^2 = (1 + M/H)(1 + dM/dH),  q = r/(1 + dM/dH).
   * The potential inside is A cosh(k q (z + d)) with shielded faces, t = tanh(k q d), and outside t' = tanh(k h);
   * a floor with vacuum below has t = (tanh(k q d) + 1/r)/(1 + tanh(k q d)/r), no ceiling t' = 1. In a deep
   * layer of linear law that is the 1 + mu_0/mu of Cowley and Rosensweig in the denominator.
   *
   * @param k  wave number [1/m].
   */
  double
  stiffness(const FerrofluidLayer &layer, const LayerField &state, const double k);

  /** s^2 = -G k tanh(k d)/rho [1/s^2] without viscosity; the wave swings where it is negative. */
  double
  inviscid_rate_square(const FerrofluidLayer &layer, const LayerField &state, const double k);

  /**
   * s [1/s] with viscosity, from the linearized equations of Navier and Stokes: the vertical velocity is a sum of
   * exp(+-k z) and exp(+-m z), m^2 = k^2 + s/nu, without shear at the surface. With slip at the floor this is
   *   (s + 2 nu k^2)^2 coth(k d) - 4 nu^2 k^3 m coth(m d) + G k/rho = 0,
   * of a deep layer Lamb's equation (Hydrodynamics, 349). Of the pair of a wave that swings, the one that turns
   * forwards; where viscosity keeps it from that, the slower one.
   */
  std::complex<double>
  wave_rate(const FerrofluidLayer &layer, const LayerField &state, const double k);

  /** The field in which the flat layer first gives way, and to which wave. */
  struct CriticalState
  {
    LayerField state;
    double wave_number; ///< k_c [1/m]
  };

  /** The least field with G = 0 at some k; of a deep layer M^2 = 2/mu_0 (1 + 1/r) sqrt(rho g gamma), k_c^2 = rho g/gamma. */
  CriticalState
  critical_state(const FerrofluidLayer &layer);

  struct FastestWave
  {
    double wave_number; ///< [1/m]
    double rate;        ///< s [1/s]
  };

  /** The wave that grows fastest above the critical state. */
  FastestWave
  fastest_wave(const FerrofluidLayer &layer, const LayerField &state);
} // namespace magmpm::verification
