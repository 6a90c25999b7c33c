#include <magmpm/boundary/rigid_bodies.h>
#include <magmpm/geometry/shape_overlap.h>
#include <magmpm/magnets/make_source.h>
#include <magmpm/motion/expression.h>
#include <magmpm/motion/pose_function.h>
#include <magmpm/parameters/given_parameters.h>
#include <magmpm/parameters/section_validation.h>

#include <algorithm>

namespace magmpm
{
  namespace
  {
    const std::vector<std::string> of_free = {"Density", "Mass", "Velocity", "Angular velocity"};
    const std::vector<std::string> of_scripted = {"Position", "Orientation", "Key frames"};

    /** Density or mass, not both. */
    void
    check_mass(const ParameterRegister &declarations,
               const std::string &section,
               const std::string &reason)
    {
      const auto given = given_of(declarations, section, {"Density", "Mass"});
      if (given.size() != 1)
        throw InputError(declarations.where(section + "/Density") + ": with " + reason +
                         " exactly one of Density and Mass must be given, but " +
                         (given.empty() ? "none" : "both") + (given.empty() ? " is." : " are."));
    }

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
      check_given(declarations, section, {}, of_free, "Motion = scripted");
      if (!input.key_frames.empty())
        {
          check_given(
            declarations, section, {"Key frames"}, {"Position", "Orientation"}, "Key frames given");
          return read_key_frames<dim>(input.key_frames, input.interpolation, where("Key frames"))
            .pose;
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
                     const ParameterInput<dim> &input,
                     const std::vector<std::unique_ptr<Shape<dim>>> &body_shapes,
                     Parameters<dim> &parameters)
  {
    std::vector<std::unique_ptr<Shape<dim>>> shapes;
    for (std::size_t i = 0; i < parameters.rigid_bodies.size(); ++i)
      {
        RigidBodyParameters<dim> &body = parameters.rigid_bodies[i];
        const MotionInput &motion      = input.rigid_body_motions[i];
        const std::string section      = "Rigid bodies/" + body.name;
        for (const SourceParameters<dim> &source : parameters.sources)
          if (source.name == body.name)
            throw declarations.error(
              "Rigid bodies/List of rigid bodies",
              "a magnet is called '" + body.name +
                "', too, and both are headings of statistics.csv. Give one of "
                "them another name.");
        shapes.push_back(check_shape(declarations, section, body.shape));
        warn_if_thin(declarations, section, shapes.back()->bounding_box(), parameters);
        if (body.is_free)
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
          if (body.is_free && parameters.rigid_bodies[r].is_free &&
              overlap(*shapes.back(), *shapes[r], 0.5 * parameters.lattice.spacing))
            throw declarations.error(section + "/Shape",
                                     "it overlaps the rigid body '" +
                                       parameters.rigid_bodies[r].name +
                                       "' at the start; move them apart.");
      }
  }

  template <int dim>
  void
  check_free_magnet(const ParameterRegister &declarations,
                    const std::string &section,
                    const SourceParameters<dim> &source)
  {
    if (!source.is_free)
      return check_given(declarations, section, {}, of_free, "Free = false");
    if (source.type == SourceType::uniform_field)
      throw declarations.error(section + "/Free", "a uniform field is nowhere; set it to false.");
    check_mass(declarations, section, "Free = true");
    if (!source.key_frames.empty())
      throw declarations.error(
        section + "/Free",
        "key frames move this magnet. Give Position and Rotation instead, or "
        "set Free = false.");
    const auto check_constant = [&](const std::string &name, const bool is_constant) {
      if (!is_constant)
        throw declarations.error(
          section + "/" + name,
          "a free magnet begins there, and forces move it: it must not depend "
          "on t. Or set Free = false.");
    };
    check_constant("Position",
                   read_expression<dim>(source.position, declarations.where(section + "/Position"))
                     .is_constant());
    if (!source.rotation.empty())
      check_constant("Rotation",
                     read_expression<n_axial_components<dim>>(
                       source.rotation, declarations.where(section + "/Rotation"))
                       .is_constant());
    if (make_source(source)->shape() == nullptr)
      throw declarations.error(section + "/Free",
                               "a source of this type has no volume, and so no inertia; set it to "
                               "false.");
  }

#define INSTANTIATE(dim)                                                             \
  template void check_rigid_bodies(const ParameterRegister &,                        \
                                   const ParameterInput<dim> &,                      \
                                   const std::vector<std::unique_ptr<Shape<dim>>> &, \
                                   Parameters<dim> &);                               \
  template void check_free_magnet(                                                   \
    const ParameterRegister &, const std::string &, const SourceParameters<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
