#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/motion/expression.h>
#include <magmpm/motion/pose_function.h>
#include <magmpm/parameters/free_body_section.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/rigid_body_section.h>
#include <magmpm/parameters/shape_section.h>

#include <algorithm>

namespace magmpm
{
  template <int dim>
  void
  declare_rigid_body(ParameterRegister &declarations,
                     RigidBodyParameters<dim> &body,
                     MotionInput &motion)
  {
    const auto section = declarations.enter(body.name);
    declare_shape(declarations, body.shape);
    declarations.add("Motion",
                     body.properties.is_free,
                     {{"free", true}, {"scripted", false}},
                     "Whether forces move it, or what is given below, whatever meets it.");
    declare_free_body(declarations, body.properties, "Of a free body: ");
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
                     body.properties.contact.condition,
                     {{"stick", ContactCondition::stick},
                      {"slip", ContactCondition::slip},
                      {"separate", ContactCondition::separate}},
                     "What material does at its surface: move with it, along it, or not into it.");
    declarations.add("Friction",
                     body.properties.contact.friction,
                     "-",
                     "Coulomb's coefficient, with Contact = slip or separate, and of rigid bodies "
                     "with walls and each other.",
                     not_negative);
    declarations.add("Contact angle",
                     body.properties.contact.contact_angle,
                     "degrees",
                     "Angle within the fluid between this surface and that of a fluid with surface "
                     "tension, with Contact = slip or separate.",
                     {0., 180.});
  }

  namespace
  {
    const std::vector<std::string> of_scripted = {"Position", "Orientation", "Key frames"};

    /** How a scripted body moves. @param centroid  where it stays if nothing else is said [m]. */
    template <int dim>
    TimeFunction<Pose<dim>>
    read_script(const ParameterRegister &declarations,
                const std::string &section,
                const MotionInput &input,
                const Vector<dim> &centroid)
    {
      const auto where = [&](const std::string &name) {
        return declarations.where(section + "/" + name);
      };
      check_given(declarations, section, {}, parameters_of_free_body, "Motion = scripted");
      if (!input.key_frames.empty())
        {
          check_given(
            declarations, section, {"Key frames"}, {"Position", "Orientation"}, "Key frames given");
          return read_key_frames<dim>(declarations, section + "/Key frames", input).pose;
        }
      TimeFunction<Vector<dim>> position = centroid;
      TimeFunction<Vector<n_axial_components<dim>>> orientation;
      if (!input.position.empty())
        position = read_expression<dim>(input.position, where("Position"));
      if (!input.rotation.empty())
        orientation = read_expression<n_axial_components<dim>>(input.rotation,
                                                               where("Orientation"));
      return pose_function(position, orientation);
    }

    /** A body thinner than this can slip between lattice nodes, and material through it. */
    constexpr double least_thickness = 2.; // of dx

    template <int dim>
    void
    warn_if_thin(const ParameterRegister &declarations,
                 const std::string &section,
                 const BoundingBox<dim> &box,
                 Parameters<dim> &parameters)
    {
      double thickness = box.upper[0] - box.lower[0];
      for (int d = 1; d < dim; ++d)
        thickness = std::min(thickness, box.upper[d] - box.lower[d]);
      if (thickness < least_thickness * parameters.lattice.spacing)
        parameters.warnings.push_back(declarations.where(section + "/Shape") + ": the body is " +
                                      to_text(thickness) +
                                      " m thick, less than two cells: it may have no lattice node "
                                      "inside, and material may pass through it.");
    }
  } // namespace

  template <int dim>
  void
  check_rigid_bodies(const ParameterRegister &declarations,
                     const std::vector<MotionInput> &motions,
                     const NamedShapes<dim> &named_shapes,
                     const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes,
                     Parameters<dim> &parameters)
  {
    std::vector<std::unique_ptr<Shape<dim>>> shapes;
    for (std::size_t i = 0; i < parameters.rigid_bodies.size(); ++i)
      {
        RigidBodyParameters<dim> &body = parameters.rigid_bodies[i];
        const MotionInput &motion      = motions[i];
        const std::string section      = "Rigid bodies/" + body.name;
        for (const SourceParameters<dim> &source : parameters.sources)
          if (source.name == body.name)
            throw declarations.error(
              "Rigid bodies/List of rigid bodies",
              "a magnet is called '" + body.name +
                "', too, and both are headings of statistics.csv. Give one of "
                "them another name.");
        shapes.push_back(check_shape(declarations, section, named_shapes, body.shape));
        warn_if_thin(declarations, section, shapes.back()->bounding_box(), parameters);
        if (body.properties.is_free)
          {
            check_given(declarations, section, {}, of_scripted, "Motion = free");
            check_mass(declarations, section, "Motion = free");
            check_inside_box(declarations,
                             section,
                             body.shape.type,
                             shapes.back()->bounding_box(),
                             parameters.lattice);
          }
        else
          body.pose =
            read_script(declarations, section, motion, shapes.back()->volume_moments().centroid);
        // A scripted body may be elsewhere at the start.
        const bool stays = motion.position.empty() && motion.key_frames.empty();
        for (std::size_t b = 0; b < body_shapes.size() && stays; ++b)
          if (body_shapes[b] != nullptr &&
              overlap(*shapes.back(), *body_shapes[b], 0.5 * parameters.lattice.spacing))
            throw declarations.error(section + "/Shape",
                                     "it overlaps the body '" + parameters.bodies[b].name +
                                       "' at the start; move them apart.");
        for (std::size_t r = 0; r + 1 < shapes.size(); ++r)
          if (body.properties.is_free && parameters.rigid_bodies[r].properties.is_free &&
              overlap(*shapes.back(), *shapes[r], 0.5 * parameters.lattice.spacing))
            throw declarations.error(section + "/Shape",
                                     "it overlaps the rigid body '" +
                                       parameters.rigid_bodies[r].name +
                                       "' at the start; move them apart.");
      }
  }

#define INSTANTIATE(dim)                                                             \
  template void declare_rigid_body(                                                  \
    ParameterRegister &, RigidBodyParameters<dim> &, MotionInput &);                 \
  template void check_rigid_bodies(const ParameterRegister &,                        \
                                   const std::vector<MotionInput> &,                 \
                                   const NamedShapes<dim> &,                         \
                                   const std::vector<std::unique_ptr<Shape<dim>>> &, \
                                   Parameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
