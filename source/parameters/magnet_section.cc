#include <magmpm/parameters/free_body_section.h>
#include <magmpm/parameters/magnet_section.h>
#include <magmpm/parameters/source_kinds.h>

#include <string>
#include <utility>
#include <vector>

namespace magmpm
{
  namespace
  {
    const std::string expressions = " Expressions of t [s], separated by semicolons.";

    template <int dim>
    void
    declare_type(ParameterRegister &declarations, MagnetInput<dim> &magnet)
    {
      std::vector<std::pair<std::string, const KindOfSource<dim> *>> types;
      for (const KindOfSource<dim> &kind : kinds_of_source<dim>())
        types.emplace_back(kind.name, &kind);
      magnet.kind = types.front().second;
      declarations.add("Type",
                       magnet.kind,
                       types,
                       "Kind of source (doc/magnets.md). In 2D a sphere is a cylinder magnetized "
                       "across its axis, a cuboid a rectangle, a dipole and a wire are lines along "
                       "z; a cylinder, a current loop and a magnetized mesh need Dimension = 3.");
    }

    template <int dim>
    void
    declare_strength(ParameterRegister &declarations, MagnetInput<dim> &magnet)
    {
      declarations.add("Field",
                       magnet.field,
                       "A/m",
                       "Of a uniform field: H(t)." + expressions,
                       Presence::optional);
      declarations.add("Magnetization",
                       magnet.magnetization,
                       "A/m",
                       "Of a sphere, cuboid, cylinder or mesh: M(t), in its own frame." +
                         expressions,
                       Presence::optional);
      declarations.add("Remanence",
                       magnet.remanence,
                       "T",
                       "The same given as B_r(t) = mu_0 M, instead of Magnetization." + expressions,
                       Presence::optional);
      declarations.add("Moment",
                       magnet.moment,
                       dim == 3 ? "A m^2" : "A m",
                       "Of a point dipole: m(t), in its own frame; in 2D per metre [A m]." +
                         expressions,
                       Presence::optional);
      declarations.add("Current",
                       magnet.current,
                       "A",
                       "Of a loop or wire: I(t), by the right hand round or along its Axis. An "
                       "expression of t [s].",
                       Presence::optional);
    }

    template <int dim>
    void
    declare_size(ParameterRegister &declarations, MagnetInput<dim> &magnet)
    {
      declarations.add("Size", magnet.size, "m", "Of a cuboid: its edges.", Presence::optional);
      declarations.add("Radius",
                       magnet.radius,
                       "m",
                       "Of a sphere, cylinder or loop: its radius. Of a point dipole: that of its "
                       "core, in which no material may be.",
                       positive,
                       Presence::optional);
      declarations.add("Conductor radius",
                       magnet.conductor_radius,
                       "m",
                       "Of a loop or wire: radius of the conductor, inside of which the field goes "
                       "to zero.",
                       positive,
                       Presence::optional);
      if constexpr (dim == 3)
        {
          declarations.add("Length",
                           magnet.length,
                           "m",
                           "Of a cylinder: its length. Of a wire: its length, its middle being at "
                           "Position; not given: it has no ends.",
                           positive,
                           Presence::optional);
          declarations.add("Axis",
                           magnet.axis,
                           "-",
                           "Of a cylinder, loop or wire: direction of its axis, of any length, in "
                           "its own frame. Not given: 0, 0, 1.",
                           Presence::optional);
          declarations.add("File",
                           magnet.file,
                           "-",
                           "Of a mesh: its file, STL, OBJ or PLY, looked for beside the parameter "
                           "file, then in the working directory. It must be closed.",
                           Presence::optional);
          declarations.add("Scale",
                           magnet.scale,
                           "-",
                           "Of a mesh: factor on the coordinates in the file. Not given: 1.",
                           positive,
                           Presence::optional);
        }
      else
        {
          declarations.refuse("Length",
                              "a wire has no ends in 2D, and a cylinder needs Dimension = 3.");
          declarations.refuse("Axis", "a wire is along z in 2D; other axes need Dimension = 3.");
          for (const char *name : {"File", "Scale"})
            declarations.refuse(name, "a mesh needs Dimension = 3.");
        }
    }

    template <int dim>
    void
    declare_motion(ParameterRegister &declarations, MagnetInput<dim> &magnet)
    {
      declarations.add("Position",
                       magnet.motion.position,
                       "m",
                       "Where the source is, x(t): its centre, or the origin of a mesh's file." +
                         expressions,
                       Presence::optional);
      declarations.add("Rotation",
                       magnet.motion.rotation,
                       "rad",
                       std::string("How it is turned (t): axis times angle; in 2D the angle.") +
                         expressions + " Not given: not turned.",
                       Presence::optional);
      declarations.add(
        "Strength",
        magnet.strength,
        "-",
        "Factor (t) of the magnetization, moment or current. An expression of t [s]. "
        "Not given: 1.",
        Presence::optional);
      declarations.add(
        "Key frames",
        magnet.motion.key_frames,
        "-",
        "Instead of Position, Rotation and Strength: a CSV file with rows of time, "
        "position, rotation (axis times angle), strength; or such rows, separated by "
        "semicolons. The last two may be left out.",
        Presence::optional);
      declarations.add("Interpolation",
                       magnet.motion.interpolation,
                       {{"linear", KeyFrameInterpolation::linear},
                        {"smooth", KeyFrameInterpolation::smooth}},
                       "Between key frames: at a constant velocity, or from rest to rest.");
    }
  } // namespace

  template <int dim>
  void
  declare_magnet(ParameterRegister &declarations, const std::string &name, MagnetInput<dim> &magnet)
  {
    const auto section = declarations.enter(name);
    declare_type(declarations, magnet);
    declare_strength(declarations, magnet);
    declare_size(declarations, magnet);
    declare_motion(declarations, magnet);
    declarations.add("Contact",
                     magnet.body.contact.condition,
                     {{"none", ContactCondition::none},
                      {"stick", ContactCondition::stick},
                      {"slip", ContactCondition::slip},
                      {"separate", ContactCondition::separate}},
                     "Of a sphere, cuboid, cylinder or mesh: what material does at its surface; "
                     "none: it has no surface.");
    declarations.add("Friction",
                     magnet.body.contact.friction,
                     "-",
                     "Coulomb's coefficient of friction at the surface, with Contact = slip or "
                     "separate.",
                     not_negative);
    declarations.add("Contact angle",
                     magnet.body.contact.contact_angle,
                     "degrees",
                     "Angle within the fluid between this surface and that of a fluid with surface "
                     "tension, with Contact = slip or separate.",
                     {0., 180.});
    declarations.add("Free",
                     magnet.body.is_free,
                     "Whether forces move it: a rigid body of its shape, with the position and "
                     "rotation that it has at the start.");
    declare_free_body(declarations, magnet.body, "Of a free magnet: ");
  }

#define INSTANTIATE(dim) \
  template void declare_magnet(ParameterRegister &, const std::string &, MagnetInput<dim> &);

  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace magmpm
