#pragma once

/** Physical constants in SI units (CODATA 2018). */
namespace magmpm::constants
{
  inline constexpr double pi = 3.14159265358979323846;

  /** Permeability of the vacuum mu_0 [N/A^2]. */
  inline constexpr double vacuum_permeability = 1.25663706212e-6;

  /** Boltzmann constant k_B [J/K]. */
  inline constexpr double boltzmann = 1.380649e-23;
} // namespace magmpm::constants
