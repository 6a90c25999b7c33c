#pragma once

#include <magmpm/boundary/surface_contact.h>
#include <magmpm/geometry/shape.h>
#include <magmpm/motion/pose.h>
#include <magmpm/motion/time_function.h>

#include <string>

namespace magmpm
{
  /** What a thing is as a rigid body, apart from its shape: the same for magnets and others. */
  template <int dim>
  struct RigidBodyProperties
  {
    SurfaceContact contact;

    bool is_free   = false; ///< whether forces move it
    double density = 0.;    ///< of a free body [kg/m^3]; 0: its mass is given
    double mass    = 0.;    ///< of a free body [kg], in 2D [kg/m]
    Vector<dim> velocity;   ///< of a free body at the start [m/s]
    Vector<n_axial_components<dim>> angular_velocity; ///< of a free body at the start [rad/s]
  };

  /** One named rigid body that is not a magnet. */
  template <int dim>
  struct RigidBodyParameters
  {
    std::string name;
    ShapeParameters<dim> shape; ///< where the body is at the start
    RigidBodyProperties<dim> properties = {{ContactCondition::separate, 0.}, true, 0., 0., {}, {}};

    /** Of one that is not free: its centroid, and how it is turned from how the shape is given. */
    TimeFunction<Pose<dim>> pose;
  };
} // namespace magmpm
