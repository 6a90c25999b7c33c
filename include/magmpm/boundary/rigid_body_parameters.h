#pragma once

#include <magmpm/boundary/surface_contact.h>
#include <magmpm/geometry/shape.h>
#include <magmpm/magnets/source_parameters.h>

#include <string>

namespace magmpm
{
  /** One named rigid body that is not a magnet. */
  template <int dim>
  struct RigidBodyParameters
  {
    std::string name;
    ShapeParameters<dim> shape; ///< where the body is at the start
    SurfaceContact contact = {ContactCondition::separate, 0.};

    bool is_free   = true;
    double density = 0.;  ///< of a free body [kg/m^3]; 0: its mass is given
    double mass    = 0.;  ///< of a free body [kg], in 2D [kg/m]
    Vector<dim> velocity; ///< of a free body at the start [m/s]
    Vector<n_axial_components<dim>> angular_velocity; ///< of a free body at the start [rad/s]

    // Of one that is not free, as of a source (SourceParameters).
    std::string position;    ///< of its centroid x(t) [m]; not given: it stays where it is
    std::string orientation; ///< axis times angle (t) [rad], from how the shape is given
    std::string key_frames;
    KeyFrameInterpolation interpolation = KeyFrameInterpolation::linear;
  };
} // namespace magmpm
