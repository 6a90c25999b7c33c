#pragma once

#include <magmpm/materials/magnetization.h>

#include <limits>

namespace magmpm::verification
{
  /** What the flow does at the floor of a layer. */
  enum class Floor
  {
    slip, ///< slides along it, as between mirrors
    stick
  };

  /** What the magnetic field does at the floor of a layer and at the ceiling above it. */
  enum class FieldFaces
  {
    open,    ///< vacuum goes on for ever
    shielded ///< its change has no normal component, as in front of a mirror
  };

  /** A flat layer of magnetizable fluid under vacuum in a vertical magnetic field. */
  struct FerrofluidLayer
  {
    double density         = 1020.;  ///< rho [kg/m^3]
    double surface_tension = 0.0245; ///< gamma [N/m]
    double gravity         = 9.81;   ///< g [m/s^2]
    double viscosity       = 0.;     ///< nu, kinematic [m^2/s]
    MagnetizationLaw law   = MagnetizationLaw::linear;
    MagneticContent medium = {0., 1.};                                ///< M_s [A/m] and chi_0 [-]
    double depth           = std::numeric_limits<double>::infinity(); ///< d [m]
    double height =
      std::numeric_limits<double>::infinity(); ///< of the ceiling over the surface [m]
    Floor floor      = Floor::slip;
    FieldFaces faces = FieldFaces::open; ///< open ones have no ceiling

    /** sqrt(rho g/gamma) [1/m], the wave number of the first wave that grows on a deep layer. */
    double
    capillary_wave_number() const;
  };

  /** The uniform field in a flat layer, along its normal. */
  struct LayerField
  {
    double field;         ///< H inside [A/m]
    double magnetization; ///< M [A/m]
    double slope;         ///< dM/dH [-]

    /** mu_0 (H + M) [T], the same inside and outside. */
    double
    induction() const;
  };

  /** @param field  H inside [A/m]. */
  LayerField
  layer_field(const FerrofluidLayer &layer, const double field);

  /** @param magnetization  M [A/m], below saturation. */
  LayerField
  field_of_magnetization(const FerrofluidLayer &layer, const double magnetization);

  /** @param induction  B [T], that of the coil without the layer. */
  LayerField
  field_of_induction(const FerrofluidLayer &layer, const double induction);
} // namespace magmpm::verification
