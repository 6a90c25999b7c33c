#include <magmpm/parameters/parameter_sections.h>

namespace magmpm
{
  namespace
  {
    const std::string components = " Expressions of t [s], separated by semicolons.";

    template <int dim>
    void
    declare_type(ParameterRegister &declarations, SourceParameters<dim> &source)
    {
      std::vector<std::pair<std::string, SourceType>> types = {
        {"uniform field", SourceType::uniform_field},
        {"point dipole", SourceType::point_dipole},
        {"magnetized sphere", SourceType::magnetized_sphere},
        {"cuboid", SourceType::cuboid},
        {"straight wire", SourceType::straight_wire}};
      if (dim == 3)
        {
          types.emplace_back("cylinder", SourceType::cylinder);
          types.emplace_back("current loop", SourceType::current_loop);
          types.emplace_back("magnetized mesh", SourceType::magnetized_mesh);
        }
      declarations.add("Type",
                       source.type,
                       types,
                       "Kind of source (doc/magnets.md). In 2D a sphere is a cylinder magnetized "
                       "across its axis, a cuboid a rectangle, a dipole and a wire are lines along "
                       "z; a cylinder, a current loop and a magnetized mesh need Dimension = 3.");
    }

    template <int dim>
    void
    declare_strength(ParameterRegister &declarations, SourceParameters<dim> &source)
    {
      declarations.add(
        "Field", source.field, "A/m", "Of a uniform field: H(t)." + components, Presence::optional);
      declarations.add("Magnetization",
                       source.magnetization,
                       "A/m",
                       "Of a sphere, cuboid, cylinder or mesh: M(t), in its own frame." +
                         components,
                       Presence::optional);
      declarations.add("Remanence",
                       source.remanence,
                       "T",
                       "The same given as B_r(t) = mu_0 M, instead of Magnetization." + components,
                       Presence::optional);
      declarations.add("Moment",
                       source.moment,
                       dim == 3 ? "A m^2" : "A m",
                       "Of a point dipole: m(t), in its own frame; in 2D per metre [A m]." +
                         components,
                       Presence::optional);
      declarations.add("Current",
                       source.current,
                       "A",
                       "Of a loop or wire: I(t), by the right hand round or along its Axis. An "
                       "expression of t [s].",
                       Presence::optional);
    }

    template <int dim>
    void
    declare_size(ParameterRegister &declarations, SourceParameters<dim> &source)
    {
      declarations.add("Size", source.size, "m", "Of a cuboid: its edges.", Presence::optional);
      declarations.add("Radius",
                       source.radius,
                       "m",
                       "Of a sphere, cylinder or loop: its radius. Of a point dipole: that of its "
                       "core, in which no material may be.",
                       positive,
                       Presence::optional);
      declarations.add("Conductor radius",
                       source.conductor_radius,
                       "m",
                       "Of a loop or wire: radius of the conductor, inside of which the field goes "
                       "to zero.",
                       positive,
                       Presence::optional);
      if constexpr (dim == 3)
        {
          declarations.add("Length",
                           source.length,
                           "m",
                           "Of a cylinder: its length. Of a wire: its length, its middle being at "
                           "Position; not given: it has no ends.",
                           positive,
                           Presence::optional);
          declarations.add("Axis",
                           source.axis,
                           "-",
                           "Of a cylinder, loop or wire: direction of its axis, of any length, in "
                           "its own frame. Not given: 0, 0, 1.",
                           Presence::optional);
          declarations.add("File",
                           source.file,
                           "-",
                           "Of a mesh: its file, STL, OBJ or PLY, looked for beside the parameter "
                           "file, then in the working directory. It must be closed.",
                           Presence::optional);
          declarations.add("Scale",
                           source.scale,
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
    declare_motion(ParameterRegister &declarations, SourceParameters<dim> &source)
    {
      declarations.add("Position",
                       source.position,
                       "m",
                       "Where the source is, x(t): its centre, or the origin of a mesh's file." +
                         components,
                       Presence::optional);
      declarations.add("Rotation",
                       source.rotation,
                       "rad",
                       std::string("How it is turned (t): axis times angle; in 2D the angle.") +
                         components + " Not given: not turned.",
                       Presence::optional);
      declarations.add(
        "Strength",
        source.strength,
        "-",
        "Factor (t) of the magnetization, moment or current. An expression of t [s]. "
        "Not given: 1.",
        Presence::optional);
      declarations.add(
        "Key frames",
        source.key_frames,
        "-",
        "Instead of Position, Rotation and Strength: a CSV file with rows of time, "
        "position, rotation (axis times angle), strength; or such rows, separated by "
        "semicolons. The last two may be left out.",
        Presence::optional);
      declarations.add("Interpolation",
                       source.interpolation,
                       {{"linear", KeyFrameInterpolation::linear},
                        {"smooth", KeyFrameInterpolation::smooth}},
                       "Between key frames: at a constant velocity, or from rest to rest.");
    }
  } // namespace

  template <int dim>
  void
  declare_source(ParameterRegister &declarations, SourceParameters<dim> &source)
  {
    const auto section = declarations.enter(source.name);
    declare_type(declarations, source);
    declare_strength(declarations, source);
    declare_size(declarations, source);
    declare_motion(declarations, source);
    declarations.add("Contact",
                     source.contact,
                     {{"none", ContactCondition::none},
                      {"stick", ContactCondition::stick},
                      {"slip", ContactCondition::slip},
                      {"separate", ContactCondition::separate}},
                     "Of a sphere, cuboid, cylinder or mesh: what material does at its surface; "
                     "none: it has no surface.");
    declarations.add("Friction",
                     source.friction,
                     "-",
                     "Coulomb's coefficient of friction at the surface, with Contact = slip or "
                     "separate.",
                     not_negative);
    declare_free_magnet(declarations, source);
  }

  template void
  declare_source(ParameterRegister &, SourceParameters<2> &);
  template void
  declare_source(ParameterRegister &, SourceParameters<3> &);
} // namespace magmpm
