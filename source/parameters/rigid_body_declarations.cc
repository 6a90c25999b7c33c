#include <magmpm/parameters/parameter_sections.h>

namespace magmpm
{
  namespace
  {
    /** Mass and start of what forces move. */
    template <int dim, typename Parameters>
    void
    declare_free_motion(ParameterRegister &declarations,
                        Parameters &parameters,
                        const std::string &of_what)
    {
      declarations.add("Density",
                       parameters.density,
                       "kg/m^3",
                       of_what + "its density, if its mass is not given.",
                       positive,
                       Presence::optional);
      declarations.add("Mass",
                       parameters.mass,
                       dim == 3 ? "kg" : "kg/m",
                       of_what + "its mass, in 2D per metre of depth, if its density is not given; "
                                 "spread evenly over its shape.",
                       positive,
                       Presence::optional);
      declarations.add("Velocity",
                       parameters.velocity,
                       "m/s",
                       of_what + "velocity of its centre of mass at the start. Not given: 0.",
                       Presence::optional);
      declarations.add("Angular velocity",
                       parameters.angular_velocity,
                       "rad/s",
                       of_what + "spin at the start about the centre of mass. Not given: 0.",
                       Presence::optional);
    }
  } // namespace

  template <int dim>
  void
  declare_free_magnet(ParameterRegister &declarations, SourceParameters<dim> &source)
  {
    declarations.add("Free",
                     source.is_free,
                     "Whether forces move it: a rigid body of its shape, with the position and "
                     "rotation that it has at the start.");
    declare_free_motion<dim>(declarations, source, "Of a free magnet: ");
  }

  template <int dim>
  void
  declare_rigid_body(ParameterRegister &declarations,
                     RigidBodyParameters<dim> &body,
                     MotionInput &motion)
  {
    const auto section = declarations.enter(body.name);
    declare_shape(declarations, body.shape);
    declarations.add("Motion",
                     body.is_free,
                     {{"free", true}, {"scripted", false}},
                     "Whether forces move it, or what is given below, whatever meets it.");
    declare_free_motion<dim>(declarations, body, "Of a free body: ");
    const std::string components = " Expressions of t [s], separated by semicolons.";
    declarations.add("Position",
                     motion.position,
                     "m",
                     "Of a scripted body: where its centroid is, x(t)." + components +
                       " Not given: where its shape is.",
                     Presence::optional);
    declarations.add("Orientation",
                     motion.rotation,
                     "rad",
                     "Of a scripted body: axis times angle by which it is turned about its "
                     "centroid, from how its shape is given." +
                       components + " Not given: 0.",
                     Presence::optional);
    declarations.add("Key frames",
                     motion.key_frames,
                     "s, m, rad",
                     "Of a scripted body: instead of Position and Orientation, rows of time, "
                     "position and axis times angle; a CSV file, or the rows, separated by "
                     "semicolons.",
                     Presence::optional);
    declarations.add("Interpolation",
                     motion.interpolation,
                     {{"linear", KeyFrameInterpolation::linear},
                      {"smooth", KeyFrameInterpolation::smooth}},
                     "Of key frames: from one to the next at a constant velocity, or from rest to "
                     "rest.");
    declarations.add("Contact",
                     body.contact.condition,
                     {{"stick", ContactCondition::stick},
                      {"slip", ContactCondition::slip},
                      {"separate", ContactCondition::separate}},
                     "What material does at its surface: move with it, along it, or not into it.");
    declarations.add("Friction",
                     body.contact.friction,
                     "-",
                     "Coulomb's coefficient, with Contact = slip or separate, and of rigid bodies "
                     "with walls and each other.",
                     not_negative);
  }

  template void
  declare_free_magnet(ParameterRegister &, SourceParameters<2> &);
  template void
  declare_free_magnet(ParameterRegister &, SourceParameters<3> &);
  template void
  declare_rigid_body(ParameterRegister &, RigidBodyParameters<2> &, MotionInput &);
  template void
  declare_rigid_body(ParameterRegister &, RigidBodyParameters<3> &, MotionInput &);
} // namespace magmpm
