#pragma once

#include <string>

namespace magmpm
{
  /** What a body does when it is deformed. */
  enum class MechanicalLaw
  {
    neo_hookean,
    viscoelastic_fluid
  };

  /** How velocities go from the lattice to the particles; see velocity_filter.h. */
  enum class Transfer
  {
    apic, ///< particles take over the lattice's velocity: what it cannot hold is lost in every step
    fmpm  ///< what a transfer to and fro would lose is given back to them
  };

  /** How the magnetization depends on the field; one law a scene. */
  enum class MagnetizationLaw
  {
    linear,
    langevin,
    table ///< a curve of points, see MagnetizationCurve
  };

  /**
   * Magnetic content of a material, all of it in undeformed full material. Either way of giving it
   * in a parameter file (saturation and susceptibility, or moment, number density and temperature)
   * ends here. Zero susceptibility: not magnetic.
   */
  struct MagneticParameters
  {
    double saturation_magnetization = 0.; ///< M_s = n m [A/m]
    double initial_susceptibility   = 0.; ///< chi_0 = mu_0 n m^2 / (3 k_B T) [-]
    double number_density           = 0.; ///< n, grains per volume [1/m^3]

    bool
    is_magnetic() const
    {
      return initial_susceptibility > 0.;
    }
  };

  /** One named material of a scene. */
  struct MaterialParameters
  {
    std::string name;
    MechanicalLaw law           = MechanicalLaw::neo_hookean;
    double shear_modulus        = 0.; ///< mu [Pa], solid
    double lame_lambda          = 0.; ///< lambda [Pa], solid
    double bulk_modulus         = 0.; ///< K [Pa], fluid
    double viscosity            = 0.; ///< mu_N [Pa s], fluid
    double sound_damping_length = 0.; ///< bulk viscosity over density and speed of sound [m], fluid
    double surface_tension      = 0.; ///< gamma [N/m], fluid; 0: none
    Transfer transfer           = Transfer::apic;

    MagneticParameters magnetic;
  };
} // namespace magmpm
