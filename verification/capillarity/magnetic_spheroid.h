#pragma once

#include <optional>

/**
 * A drop of a linear medium in a uniform field, without gravity, that is taken to be a prolate spheroid (2D: an ellipse):
 * Bacri and Salin, J. Physique Lett. 43 (1982). Lengths are in R, the radius of the sphere of its volume, energies in
 * gamma R^2 (2D: gamma R), and the field comes in by the magnetic Bond number
 *   N = mu_0 H_0^2 R/gamma.
 */
namespace magmpm::verification
{
  struct MagneticDrop
  {
    int dim               = 3;
    double susceptibility = 1.; ///< chi
  };

  /**
   * Surface less mu_0/2 V M H_0:  S(K) - N/2 V chi/(1 + chi n(K)), V = 4 pi/3 (2D: pi), n the demagnetizing factor.
   *
   * @param aspect  K, long over short axis, at least 1.
   */
  double
  spheroid_energy(const MagneticDrop &drop, const double bond_number, const double aspect);

  /** N at which the energy does not change with the aspect ratio, S'(K)/(V/2 d/dK chi/(1 + chi n)). @param aspect  above 1. */
  double
  bond_number_of_aspect(const MagneticDrop &drop, const double aspect);

  /** Where a drop jumps: with N rising from the first to a long one, with N falling from the second to a short one. */
  struct Hysteresis
  {
    double aspect_up, bond_up;     ///< the largest N of short drops
    double aspect_down, bond_down; ///< the least N of long ones
  };

  /** None if N only rises with the aspect ratio, up to 1000: in 3D for chi below 19.8. */
  std::optional<Hysteresis>
  hysteresis(const MagneticDrop &drop);

  /** The aspect ratio of least energy, the shortest such. @param bond_number  below that of a jump, if there is one. */
  double
  spheroid_aspect(const MagneticDrop &drop, const double bond_number);
} // namespace magmpm::verification
